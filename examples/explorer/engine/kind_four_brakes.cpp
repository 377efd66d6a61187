#include "kind_of.hpp"

#include <passive_haptics/mechanism/models/five_bar.hpp>

std::unique_ptr<explorer::device_kind> explorer::four_brakes(const runtime::any_mechanism& mechanism) {
  return kind_if<ph::five_bar<double, 4>>(mechanism);
}
