#include "rods.hpp"

namespace {
const bool added = worst_case::add_rods<4, 2>("chain of 4 in the plane");
}  // namespace
