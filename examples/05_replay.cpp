// Replays a log of a device's motion under a control law and writes the commands: a log of brake_driver, of a
// simulation, or of your own program. The device is that of a device file.
#include <catalogue/catalogue.hpp>
#include <log/replay_program.hpp>

int main(int argc, char** argv) { return example::replay_program(argc, argv, example::catalogue()); }
