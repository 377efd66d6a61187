# A wrong use must not compile, and the first error must match line one: `// expect: <regex>`.
set(ENV{LC_ALL} C)
file(READ ${source} text LIMIT 1000)
if(NOT text MATCHES "^// expect: ([^\n]+)")
  message(FATAL_ERROR "${source}: line one must be `// expect: <regex>`")
endif()
set(expected "${CMAKE_MATCH_1}")

list(TRANSFORM includes PREPEND -I)
if(prelude AND NOT text MATCHES "#define")  # what it defines must come first
  list(APPEND includes -include ${prelude})
endif()
execute_process(COMMAND ${compiler} -std=c++20 -fsyntax-only ${includes} ${source}
  RESULT_VARIABLE status ERROR_VARIABLE errors)
if(status EQUAL 0)
  message(FATAL_ERROR "${source} compiles; expected an error matching '${expected}'")
endif()

string(REGEX MATCH "[^\n]*error:[^\n]*" first "${errors}")
if(NOT first MATCHES "${expected}")
  message(FATAL_ERROR "first error: ${first}\nexpected:    ${expected}\n\n${errors}")
endif()
message("first error: ${first}")
