// Drives the brakes of a real device, or of a simulated one, at 1 kHz.
#include <driver_program.hpp>

int main(int argc, char** argv) { return example::driver_program(argc, argv); }
