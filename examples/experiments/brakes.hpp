// The planar wall with every kind of brake that the library has a model of.
#pragma once

#include "markdown.hpp"

namespace experiments {

// Every law with every kind of brake, and the recommended law that knows more or less of its brakes: the
// tables laws_and_brakes_hold, laws_and_brakes_feel and known_of_brakes.
void laws_and_brakes(page_tables& page);

// Whether the recommended law leaves the wall with no kind of brake.
bool holds_with_every_brake(double time_step);

}  // namespace experiments
