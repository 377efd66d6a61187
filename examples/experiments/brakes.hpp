// The planar wall with every brake model of the library.
#pragma once

#include "markdown.hpp"

namespace experiments {

// Every law with every brake model, and the recommended law with more or less knowledge of its brakes: the
// tables laws_and_brakes_hold, laws_and_brakes_feel and known_of_brakes.
void laws_and_brakes(page_tables& page);

// True if the recommended law never leaves the wall with any brake model.
bool holds_with_every_brake(double time_step);

}  // namespace experiments
