# A program prints what a file holds.
execute_process(COMMAND ${program} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
file(READ ${expected} text)
if(NOT printed STREQUAL text)
  message(FATAL_ERROR "${expected} is not what the program prints:\n${printed}")
endif()
