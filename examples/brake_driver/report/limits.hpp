/// @file
/// What the first wall of a configuration can be.
#pragma once

#include <configuration/configuration.hpp>

namespace example {

/// Prints it, of the wall calculator (docs/guide/wall_limits.md) at the home pose, for the hand of
/// [simulation] and several speeds of approach.
void print_limits(const configuration& c);

}  // namespace example
