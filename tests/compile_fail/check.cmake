# A wrong use must not compile, and the first error must match line one: `// expect: <regex>`.
set(ENV{LC_ALL} C)
file(READ ${source} text LIMIT 1000)
if(NOT text MATCHES "^// expect: ([^\n]+)")
  message(FATAL_ERROR "${source}: line one must be `// expect: <regex>`")
endif()
set(expected "${CMAKE_MATCH_1}")

separate_arguments(flags UNIX_COMMAND "${flags}")
list(TRANSFORM includes PREPEND -I)
# Not for what defines something first, or is wrong by what it does not include
if(NOT text MATCHES "#define" AND text MATCHES "#include <passive_haptics/passive_haptics.hpp>")
  list(APPEND includes -include ${prelude})
endif()
execute_process(COMMAND ${compiler} ${flags} -std=c++20 -fsyntax-only -Wfatal-errors ${includes} ${source}
  RESULT_VARIABLE status ERROR_VARIABLE errors)
if(status EQUAL 0)
  message(FATAL_ERROR "${source} compiles; expected an error matching '${expected}'")
endif()

string(REGEX MATCH "[^\n]*error:[^\n]*" first "${errors}")
if(NOT first MATCHES "${expected}")
  message(FATAL_ERROR "first error: ${first}\nexpected:    ${expected}\n\n${errors}")
endif()
message("first error: ${first}")
