// What a stiff hand feels of the forces of arms with self-motion.
#pragma once

#include <string>

namespace experiments {

// Of three arms, as a table of Markdown.
std::string felt_forces();

}  // namespace experiments
