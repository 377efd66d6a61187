// slow, optimised
// Brakes on some of the joints.
#include "chain_cases.hpp"

#include <passive_haptics/mechanism/adaptors/braked_joints.hpp>
#include <passive_haptics/testing/dynamics_properties.hpp>
#include <passive_haptics/testing/fault_properties.hpp>
#include <passive_haptics/testing/mechanism_properties.hpp>
#include <passive_haptics/testing/step_properties.hpp>

namespace passive_haptics::testing {
namespace {

template <class Chain, int... Brakes>
struct with_brakes_on : Chain {
  using mechanism = braked_joints<typename Chain::mechanism, Brakes...>;
  static mechanism make() { return mechanism(Chain::make()); }
};

using two_of_three = with_brakes_on<chains::irregular_chain<double, 3, 2>, 0, 2>;
using three_of_four = with_brakes_on<chains::irregular_chain<float, 4, 3>, 3, 0, 1>;

}  // namespace

INSTANTIATE_TYPED_TEST_SUITE_P(fewer_brakes, mechanism_properties, three_of_four);
INSTANTIATE_TYPED_TEST_SUITE_P(fewer_brakes, dynamics_properties, three_of_four);
INSTANTIATE_TYPED_TEST_SUITE_P(fewer_brakes, step_properties, two_of_three);
INSTANTIATE_TYPED_TEST_SUITE_P(fewer_brakes, fault_properties, two_of_three);

}  // namespace passive_haptics::testing
