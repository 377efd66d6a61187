#include "rods.hpp"

namespace {
using namespace worst_case;
const bool added = add("delta", ph::delta<double>()) && add_rods<3, 3>("chain of 3 in space");
}  // namespace
