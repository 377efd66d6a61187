# What callgrind counts, for the budgets.

# The rows that a program lists.
function(rows_of program result)
  execute_process(COMMAND ${program} OUTPUT_VARIABLE rows COMMAND_ERROR_IS_FATAL ANY)
  string(STRIP "${rows}" rows)
  string(REPLACE "\n" ";" rows "${rows}")
  set(${result} "${rows}" PARENT_SCOPE)
endfunction()

# Instructions of one cycle of a row: of all that runs below counted(), by the number of cycles that the program tells.
function(count_instructions valgrind program row result)
  execute_process(
    COMMAND ${valgrind} --tool=callgrind --toggle-collect=counted --callgrind-out-file=/dev/null ${program} ${row}
    OUTPUT_VARIABLE said ERROR_VARIABLE log COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCH "cycles: ([0-9]+)" matched "${said}")
  set(cycles ${CMAKE_MATCH_1})
  string(REGEX MATCH "Collected : ([0-9]+)" matched "${log}")
  math(EXPR count "${CMAKE_MATCH_1} / ${cycles}")
  set(${result} ${count} PARENT_SCOPE)
endfunction()
