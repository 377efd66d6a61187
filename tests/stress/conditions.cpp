// Jacobians of conditions up to 1e16, and singular ones: the displayed force stays feasible, whatever the
// condition.
#include "devices.hpp"
#include "edge_suite.hpp"

#include <optional>

namespace stress {

template <class M>
struct conditions : ::testing::Test {};

using linear_devices = ::testing::Types<linear_device<double, 2>, linear_device<double, 3>>;
TYPED_TEST_SUITE(conditions, linear_devices);

TYPED_TEST(conditions, break_no_law) {
  using M = TypeParam;
  using T = typename M::scalar;
  const std::uint64_t seed = first_seed();
  for (const double condition : {1e0, 1e2, 1e4, 1e6, 1e8, 1e10, 1e12, 1e14, 1e16, HUGE_VAL}) {
    SCOPED_TRACE(::testing::Message() << "condition " << condition);
    gauntlet<M> cycles(seed, effort(2000, 100000));
    std::optional<M> device;
    const auto make = [&](std::uint64_t k) -> const M& {
      ph::testing::random_source random(k);
      return device.emplace(condition, random);
    };
    cycles.run(make, ph::joint_vector<M>::Constant(T(-1)), ph::joint_vector<M>::Constant(T(1)));
    if (this->HasFatalFailure()) return;
  }
}

}  // namespace stress
