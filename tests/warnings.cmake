# The warnings of our own programs: the target passive_haptics_warnings.
include_guard(GLOBAL)
add_library(passive_haptics_warnings INTERFACE)
target_compile_options(passive_haptics_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion
  $<$<NOT:$<BOOL:${PASSIVE_HAPTICS_BATCH_TESTS}>>:-Wshadow>  # which a file in a batch owes to its neighbours
  $<$<BOOL:${PASSIVE_HAPTICS_WARNINGS_AS_ERRORS}>:-Werror>)
