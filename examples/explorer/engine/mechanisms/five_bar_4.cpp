// A five-bar with four brakes: on both base rates, their difference and their sum.
#include "five_bars.hpp"

namespace explorer {
namespace {

struct description : five_bars<4> {
  static constexpr const char *id = "five_bar_4", *label = "Five-bar, four brakes";
  static constexpr const char* device_type = "five_bar_with_four_brakes";
};

}  // namespace

mechanism_entry five_bar_4_entry() { return entry_of<description>(); }

}  // namespace explorer
