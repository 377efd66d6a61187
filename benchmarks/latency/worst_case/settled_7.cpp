#include "rods.hpp"

namespace {
const bool added = worst_case::add_rods<7, 3>("chain of 7 in space");
}  // namespace
