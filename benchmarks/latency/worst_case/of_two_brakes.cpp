#include "devices.hpp"

namespace {
using namespace worst_case;
const bool added = add("tendon_two_link", ph::tendon_two_link<double>()) &&
                   add("two_link", ph::two_link<double>()) && add("xy_table", ph::xy_table<double>()) &&
                   add("five_bar, 2 brakes", ph::five_bar<double, 2>());
}  // namespace
