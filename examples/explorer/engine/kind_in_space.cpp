// The delta and the arm in space.
#include "kind_of.hpp"

#include <passive_haptics/mechanism/models/delta.hpp>

std::unique_ptr<explorer::device_kind> explorer::in_space(const runtime::any_mechanism& mechanism) {
  return kind_if<ph::delta<double>>(mechanism);
}
