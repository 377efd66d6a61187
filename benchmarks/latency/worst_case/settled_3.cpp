#include "rods.hpp"

namespace {
const bool added = worst_case::add_rods<3, 2>("chain of 3 in the plane");
}  // namespace
