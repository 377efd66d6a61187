// A five-bar with a brake on each base joint.
#include "five_bars.hpp"

namespace explorer {
namespace {

struct description : five_bars<2> {
  static constexpr const char *id = "five_bar", *label = "Five-bar, two brakes";
};

}  // namespace

mechanism_entry five_bar_entry() { return entry_of<description>(); }

}  // namespace explorer
