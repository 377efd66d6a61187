#include "chains.hpp"
#include "kind_of.hpp"

std::unique_ptr<explorer::device_kind> explorer::self_motion(const runtime::any_mechanism& mechanism) {
  return kind_if<planar_3r>(mechanism);
}
