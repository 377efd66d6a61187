#include "scara.hpp"

#include <passive_haptics/testing/dynamics_properties.hpp>
#include <passive_haptics/testing/mechanism_properties.hpp>

struct scara_case {
  using mechanism = scara;
  static scara make() { return scara(); }
  static ph::vector<double, 2> lower() { return {-3, -3}; }
  static ph::vector<double, 2> upper() { return {3, 3}; }
};

namespace passive_haptics::testing {
INSTANTIATE_TYPED_TEST_SUITE_P(scara, mechanism_properties, scara_case);
INSTANTIATE_TYPED_TEST_SUITE_P(scara, dynamics_properties, scara_case);  // from step 5 on
}  // namespace passive_haptics::testing
