#include "devices.hpp"

namespace {
using namespace worst_case;
const bool added = add("five_bar, 4 brakes", ph::five_bar<double, 4>());
}  // namespace
