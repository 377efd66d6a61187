/// The program brake_driver, for programs that add devices of their own.
#pragma once

namespace example {

/// main() of brake_driver for the mechanisms, laws, shapes and brake models of example::catalogue(). Returns
/// the exit status.
int driver_program(int argc, char** argv);

}  // namespace example
