# An optimised control cycle may call mathematics and copy memory, and end the program if something beneath its
# noexcept throws or an assertion of the standard library fails; nothing that allocates, throws, locks or reads a clock.
# Needs: nm, object.
set(ENV{LC_ALL} C)
set(allowed
  sin|cos|sincos|sqrt|acos|atan2|hypot|fma|sinf|cosf|sincosf|sqrtf|acosf|atan2f|hypotf|fmaf
  memcpy|memmove|memset|memcmp|bcmp
  _GLOBAL_OFFSET_TABLE_|__stack_chk_fail
  __gxx_personality_v0|__cxa_begin_catch|_ZSt9terminatev|_ZSt21__glibcxx_assert_fail.*)
list(JOIN allowed "|" allowed)

execute_process(COMMAND ${nm} ${object} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
if(NOT symbols MATCHES " T cycle_")
  message(FATAL_ERROR "no control cycle in ${object}:\n${symbols}")
endif()

string(REGEX MATCHALL " U [^\n]+" undefined "${symbols}")
list(TRANSFORM undefined REPLACE "^ U ([^@\n]*).*" "\\1")
message("a control cycle calls: ${undefined}")
list(FILTER undefined EXCLUDE REGEX "^(${allowed})$")
if(undefined)
  message(FATAL_ERROR "a control cycle must not call: ${undefined}")
endif()
