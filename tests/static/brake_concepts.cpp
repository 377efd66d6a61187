// Brakes: what fits, what only looks like it; more of the latter is in tests/compile_fail/brakes.cpp.
#include <passive_haptics/passive_haptics.hpp>

#include <type_traits>

namespace ph = passive_haptics;

namespace {

using V2 = ph::vector<double, 2>;
using arm = ph::two_link<double>;

static_assert(ph::BrakesFor<ph::brakes_of<arm>, arm> && ph::BrakesFor<ph::unlimited_brakes, arm>);
static_assert(ph::LimitedBrakes<ph::brakes_of<arm>, double, 2> &&
              ph::StickingBrakes<ph::brakes_of<arm>, double, 2> &&
              ph::TorqueDeadBandBrakes<ph::brakes_of<arm>, double, 2> &&
              ph::LaggingBrakes<ph::brakes_of<arm>, double, 2>);
static_assert(!ph::LimitedBrakes<ph::unlimited_brakes, double, 2> &&
              !ph::StickingBrakes<ph::unlimited_brakes, double, 2> &&
              !ph::TorqueDeadBandBrakes<ph::unlimited_brakes, double, 2> &&
              !ph::LaggingBrakes<ph::unlimited_brakes, double, 2>);
static_assert(std::is_empty_v<ph::unlimited_brakes>);

// ---- what a type tells of its brakes

struct limits {
  V2 torque_limit;
};
struct dead_bands {
  static constexpr bool unlimited = true;
  V2 rate_dead_band;
};
struct limits_in_float {
  ph::vector<float, 2> torque_limit;
};
struct rate_dead_band_of_three : limits {
  ph::vector<double, 3> rate_dead_band;
};
struct torque_dead_band_of_three : dead_bands {
  ph::vector<double, 3> torque_dead_band;
};
struct lag_as_number {
  static constexpr bool unlimited = true;
  double time_constant;
};
static_assert(ph::BrakesFor<limits, arm> && ph::LimitedBrakes<limits, double, 2> &&
              !ph::StickingBrakes<limits, double, 2>);
static_assert(ph::BrakesFor<dead_bands, arm> && !ph::TorqueDeadBandBrakes<dead_bands, double, 2>);
static_assert(!ph::BrakesFor<limits_in_float, arm> && !ph::BrakesFor<lag_as_number, arm>);
static_assert(!ph::BrakesFor<rate_dead_band_of_three, arm> && !ph::BrakesFor<torque_dead_band_of_three, arm>);
struct lower_alone : limits {
  V2 torque_lower;
};
struct interval : lower_alone {
  V2 torque_upper;
};
struct interval_in_float : limits {
  ph::vector<float, 2> torque_lower, torque_upper;
};
struct interval_without_limit {
  static constexpr bool unlimited = true;
  V2 torque_lower, torque_upper;
};
static_assert(ph::BrakesFor<interval, arm> && ph::SwitchableBrakes<interval, double, 2> &&
              ph::BrakesFor<interval_without_limit, arm> && ph::BrakesFor<ph::switchable_brakes<arm>, arm>);
static_assert(!ph::BrakesFor<interval_in_float, arm> && !ph::SwitchableBrakes<ph::brakes_of<arm>, double, 2>);
static_assert(!ph::BrakesFor<limits, int> && !ph::BrakesFor<limits, limits>, "no mechanism");
static_assert(!ph::BrakesFor<double, arm> && !ph::BrakesFor<ph::brakes_of<ph::two_link<float>>, arm>);

// What a law says that it needs
static_assert(!ph::needs_hand_force<ph::no_direct_control> && ph::needs_hand_force<ph::direct_control>);
static_assert(!ph::needs_dynamics<ph::direct_control> && ph::needs_dynamics<ph::velocity_direct_control>);

// A controller's brakes are those that it is made of, brakes_of<M> where nothing else is said
using plane = ph::static_scene<ph::half_space<2>>;
static_assert(std::is_same_v<ph::controller<arm, plane, ph::direct_control>,
                             ph::controller<arm, plane, ph::direct_control, ph::brakes_of<arm>>>);
using braced = decltype(ph::controller(arm(), {}, std::declval<plane>(), ph::direct_control()));
static_assert(std::is_same_v<braced, ph::controller<arm, plane, ph::direct_control>>);
static_assert(sizeof(ph::controller<arm, plane, ph::direct_control, ph::unlimited_brakes>) +
                  sizeof(ph::brakes_of<arm>) <=
              sizeof(braced));

}  // namespace
