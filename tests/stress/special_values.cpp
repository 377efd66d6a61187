// Special values in every number that a step reads, two walls at once, and the options: a fault or a lawful
// step. With one wall the suite fault_properties does this.
#include "broken_law.hpp"
#include "devices.hpp"

#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/testing/support/step_samples.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace stress {

TEST(special_values, in_any_position_break_no_law) {
  using device = device_case<ph::tendon_two_link<double>>;
  using M = device::mechanism;
  using T = M::scalar;
  using limits = std::numeric_limits<T>;
  constexpr unsigned seed = 20040627;
  constexpr int d = M::task_dimension;
  const M mechanism = device::make();
  int faults = 0, lawful = 0;
  ph::testing::for_each_sample<device>(mechanism, seed, 2, [&](ph::testing::step_sample<M> sample) {
    ph::contact<d> wall = sample.wall(), other = sample.wall();
    other.normal = ph::point<d>(-wall.normal.reverse());
    ph::step_options<T> options;
    const auto run = [&](const std::string& name, auto& value) {
      using X = std::remove_reference_t<decltype(value)>;
      const X good = value;
      for (const T special :
           {limits::quiet_NaN(), limits::infinity(), -limits::infinity(), T(0), -T(0), limits::denorm_min(),
            limits::min(), limits::epsilon(), limits::max(), limits::lowest()}) {
        value = static_cast<X>(special);
        SCOPED_TRACE(::testing::Message() << "seed " << seed << ", " << name << " = " << special);
        const auto check = [&]<class L>(const L& control) {
          for (const bool first : {true, false}) {
            ph::contacts<d, 2> touched;
            touched.push_back(first ? wall : other);
            touched.push_back(first ? other : wall);
            ph::step_memory<L> memory;
            const auto result =
                ph::step(mechanism, sample.brakes, touched, control, sample.state, memory, options);
            const char* law = broken_law_of<L>(mechanism, sample.brakes, sample.state, 2, result);
            EXPECT_EQ(law, nullptr) << law;
            EXPECT_TRUE(std::isfinite(special) || result.outcome != ph::status::ok);
            ++(result.outcome == ph::status::ok ? lawful : faults);
          }
        };
        check(ph::direct_control());
        if constexpr (ph::Dynamics<M>) check(ph::velocity_direct_control());
      }
      value = good;
    };
    ph::testing::for_each_input(sample, wall, run);
    run("min_cosine", options.min_cosine);
  });
  std::printf("%d faults, %d lawful steps\n", faults, lawful);
  EXPECT_GT(faults, 0);
  EXPECT_GT(lawful, faults);
}

}  // namespace stress
