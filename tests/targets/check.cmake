# The golden cycles by one compiler: what they print is golden.txt, bit by bit or, with bounds, within them.
# Needs: program; or compiler, flags, run, includes, platform (hosted if not given), suffix (of a program), nm (where
# there shall be no heap);
# compare, expected, directory, bounds ("in double, in float").
include(${CMAKE_CURRENT_LIST_DIR}/build.cmake)
if(NOT program)
  set(program ${directory}/golden${suffix})
  build(golden.cpp ${program} -O1 -DPASSIVE_HAPTICS_FLATTEN=)
endif()
if(nm)
  include(${CMAKE_CURRENT_LIST_DIR}/../driver/firmware_arm/small.cmake)
  require_no_heap("the golden test" ${program})
endif()
run(${program} said)
file(WRITE ${directory}/golden.txt "${said}")
separate_arguments(bounds UNIX_COMMAND "${bounds}")
execute_process(COMMAND ${compare} ${expected} ${directory}/golden.txt ${bounds} COMMAND_ERROR_IS_FATAL ANY)
