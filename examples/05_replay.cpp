// Runs a log of a device's motion through a control law and writes what would have been commanded: a
// log of brake_driver, of a simulation, or of your own program. The device is that of a device file.
#include <catalogue/catalogue.hpp>
#include <log/replay_program.hpp>

int main(int argc, char** argv) { return example::replay_program(argc, argv, example::catalogue()); }
