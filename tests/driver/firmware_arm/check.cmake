# The firmware compiles and links for an STM32F4, calls for no heap, and is small.
# Needs: compiler, size, nm, firmware (its folder), directory.
set(max_flash 4096)  # [bytes]; of 1 MiB
set(max_ram 2048)    # [bytes] without the stack; of 128 KiB
file(MAKE_DIRECTORY ${directory})
set(board stm32f4)
set(elf ${directory}/brake_firmware.elf)
include(${CMAKE_CURRENT_LIST_DIR}/build.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/small.cmake)
require_no_heap(firmware ${elf})
require_small(firmware ${elf} ${max_flash} ${max_ram})

execute_process(COMMAND ${nm} ${elf} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
if(NOT symbols MATCHES "08000000 . [^\n]*table")
  message(FATAL_ERROR "the vector table is not where the core looks for it:\n${symbols}")
endif()
