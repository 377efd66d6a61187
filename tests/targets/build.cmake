# What the tests of targets share. Needs: compiler, flags, run, includes, platform, directory.
file(MAKE_DIRECTORY ${directory})
if(NOT platform)
  set(platform hosted)
endif()
separate_arguments(flags UNIX_COMMAND "${flags}")
separate_arguments(run UNIX_COMMAND "${run}")
list(TRANSFORM includes PREPEND -isystem)

# build(SOURCE PROGRAM OPTION...): skips the test where the compiler has no standard library for these flags.
macro(build source program)
  file(WRITE ${directory}/probe.cpp "#include <vector>\n")
  execute_process(COMMAND ${compiler} -std=c++20 ${flags} -fsyntax-only ${directory}/probe.cpp
    RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
  if(NOT status EQUAL 0)
    execute_process(COMMAND ${CMAKE_COMMAND} -E echo "skipped: ${compiler} has no standard library for ${flags}")
    return()
  endif()
  execute_process(COMMAND ${compiler} -std=c++20 -DNDEBUG ${ARGN} ${includes} ${CMAKE_CURRENT_LIST_DIR}/${source}
    ${CMAKE_CURRENT_LIST_DIR}/${platform}.cpp ${flags} -o ${program} COMMAND_ERROR_IS_FATAL ANY)
endmacro()

# run(PROGRAM OUTPUT): what it prints.
macro(run program output)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env WINEDEBUG=-all WINEPREFIX=${directory}/wine ${run} ${program}
    OUTPUT_VARIABLE ${output} COMMAND_ERROR_IS_FATAL ANY)
endmacro()
