# The firmware compiles and links for an STM32F4, calls for no heap, and is small.
# Needs: compiler, size, nm, firmware (its folder), directory.
set(most_flash 4096)  # [bytes]; of 1 MiB
set(most_ram 2048)    # [bytes] without the stack; of 128 KiB
file(MAKE_DIRECTORY ${directory})
set(board stm32f4)
set(elf ${directory}/brake_firmware.elf)
include(${CMAKE_CURRENT_LIST_DIR}/build.cmake)

execute_process(COMMAND ${nm} ${elf} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
if(symbols MATCHES " (malloc|_sbrk|_Znwj|__cxa_throw|abort)\n")
  message(FATAL_ERROR "the firmware must not call ${CMAKE_MATCH_1}")
endif()
if(NOT symbols MATCHES "08000000 . [^\n]*table")
  message(FATAL_ERROR "the vector table is not where the core looks for it:\n${symbols}")
endif()

execute_process(COMMAND ${size} ${elf} OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCH "\n *([0-9]+)[ \t]+([0-9]+)[ \t]+([0-9]+)" found "${said}")
math(EXPR flash "${CMAKE_MATCH_1} + ${CMAKE_MATCH_2}")
math(EXPR ram "${CMAKE_MATCH_2} + ${CMAKE_MATCH_3}")
message("firmware: ${flash} bytes of flash, ${ram} bytes of memory")
if(flash GREATER most_flash OR ram GREATER most_ram)
  message(FATAL_ERROR "expected at most ${most_flash} and ${most_ram}")
endif()
