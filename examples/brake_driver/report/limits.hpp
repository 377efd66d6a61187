/// Limits of the first wall of a configuration.
#pragma once

#include <configuration/configuration.hpp>

namespace example {

/// Prints results of the wall calculator (docs/guide/design.md) at the home pose, for the hand of
/// [simulation] and several speeds of approach.
void print_limits(const configuration& c);

}  // namespace example
