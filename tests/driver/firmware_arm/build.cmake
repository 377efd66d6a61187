# The firmware for a Cortex-M4 on a board: without operating system, exceptions or run-time types.
# Needs: compiler, firmware (its folder), board (a folder in it), elf.
execute_process(COMMAND ${compiler} -std=c++20 -mcpu=cortex-m4 -mthumb -ffreestanding -fno-exceptions -fno-rtti -Os
  -ffunction-sections -Wall -Wextra -Wconversion -Wshadow -Werror -I ${firmware}/.. -I ${firmware}/${board}
  ${firmware}/main_cortex_m.cpp ${firmware}/startup_cortex_m.cpp ${firmware}/${board}/board.cpp
  -nostartfiles --specs=nano.specs -Wl,--gc-sections -L ${firmware}/${board} -T ${firmware}/cortex_m.ld -lm -o ${elf}
  COMMAND_ERROR_IS_FATAL ANY)
