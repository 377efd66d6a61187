#include "rods.hpp"

namespace {
const bool added = worst_case::add_rods<6, 3>("chain of 6 in space");
}  // namespace
