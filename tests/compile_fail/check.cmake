# The row `#ifdef row ... #endif` of a table must not compile, and the first error must contain the text of the comment
# that follows, `// error: TEXT`.
set(ENV{LC_ALL} C)
file(READ ${table} text)
if(NOT text MATCHES "#ifdef ${row}\n// error: ([^\n]+(\n// [^\n]+)*)\n")
  message(FATAL_ERROR "${table}: no `#ifdef ${row}` with `// error: TEXT` below")
endif()
string(REPLACE "\n// " " " expected "${CMAKE_MATCH_1}")

separate_arguments(flags UNIX_COMMAND "${flags}")
list(TRANSFORM includes PREPEND -I)
if(text MATCHES "^#include \"prelude.hpp\"")
  list(APPEND includes -include ${prelude})
endif()
execute_process(COMMAND ${compiler} ${flags} -std=c++20 -fsyntax-only -Wfatal-errors ${includes} -D ${row} ${table}
  RESULT_VARIABLE status ERROR_VARIABLE errors)
if(status EQUAL 0)
  message(FATAL_ERROR "${row} compiles; expected: ${expected}")
endif()

string(REGEX MATCH "[^\n]*error:[^\n]*" first "${errors}")
string(FIND "${first}" "${expected}" found)
if(found EQUAL -1)
  message(FATAL_ERROR "first error: ${first}\nexpected:    ${expected}\n\n${errors}")
endif()
message("first error: ${first}")
