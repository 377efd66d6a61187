// What a stiff hand feels of settled, inertial and kinetostatic forces.
#pragma once

#include <string>

namespace experiments {

// Of three arms, as a table of Markdown.
std::string felt_forces();

}  // namespace experiments
