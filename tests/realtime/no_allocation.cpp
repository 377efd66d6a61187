// A control cycle allocates nothing, whichever way it takes. no_allocation_elsewhere.cpp has the other
// devices and laws.
#include "allocations.hpp"

#include "ways.hpp"

#include <memory>
#include <string>

namespace {

TEST(no_allocation, is_noticed_where_there_is_one) {
  std::unique_ptr<int> kept;
  EXPECT_EQ(allocations_in([&] { kept = std::make_unique<int>(3); }), 1);
  std::string text;
  EXPECT_GE(allocations_in([&] { text.assign(1000, 'x'); }), 1);
  EXPECT_EQ(allocations_in([] {}), 0);
  EXPECT_DEATH(allocations_in([] { Eigen::VectorXd::Ones(7).eval(); }), "malloc");
}

TEST(no_allocation, in_a_step_of_the_tendon_device) { run_all(ph::tendon_two_link<double>(), 0.3); }

}  // namespace
