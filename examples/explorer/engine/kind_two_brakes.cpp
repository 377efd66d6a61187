// Two links, five-bars and XY tables: the kinds share templates, so one source takes a third of the time.
#include "kind_of.hpp"

#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>

std::unique_ptr<explorer::device_kind> explorer::two_brakes(const runtime::any_mechanism& mechanism) {
  auto found = kind_if<ph::tendon_two_link<double>>(mechanism);
  if (!found) found = kind_if<ph::two_link<double>>(mechanism);
  return found ? std::move(found) : kind_if<ph::xy_table<double>>(mechanism);
}
