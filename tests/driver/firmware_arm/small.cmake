# What is asked of a program for a microcontroller. Needs: size, nm.

# require_no_heap(WHAT ELF)
function(require_no_heap what elf)
  execute_process(COMMAND ${nm} ${elf} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
  if(symbols MATCHES " (malloc|_malloc_r|_sbrk|_Znwj|__cxa_throw|abort)\n")
    message(FATAL_ERROR "${what} must not call ${CMAKE_MATCH_1}")
  endif()
endfunction()

# require_small(WHAT ELF MOST_FLASH MOST_RAM): no more [bytes], memory without the stack.
function(require_small what elf max_flash max_ram)
  execute_process(COMMAND ${size} ${elf} OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCH "\n *([0-9]+)[ \t]+([0-9]+)[ \t]+([0-9]+)" found "${said}")
  math(EXPR flash "${CMAKE_MATCH_1} + ${CMAKE_MATCH_2}")
  math(EXPR ram "${CMAKE_MATCH_2} + ${CMAKE_MATCH_3}")
  message("${what}: ${flash} bytes of flash, ${ram} bytes of memory")
  if(flash GREATER max_flash OR ram GREATER max_ram)
    message(FATAL_ERROR "expected at most ${max_flash} and ${max_ram}")
  endif()
endfunction()
