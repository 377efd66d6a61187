// Runs with the XY table: slides with a brake each, at 0.1 m from the brake's axis.
#include "planar_run.hpp"

namespace experiments {

run_result follow_with_table(law which, const test_wall& wall, const setup& how) {
  using table = ph::xy_table<double>;
  constexpr double radius = 0.1;  // [m]
  device<table> d{table(), table(), {}, {}, ph::encoder_parameters().resolution * radius, {}};
  d.brakes.torque_limit.setConstant(how.limit / radius);  // [N]
  d.brakes.time_constant.setConstant(how.lag);
  d.brakes.rate_dead_band *= radius;  // [m/s]
  d.real_brakes = ph::ideal_brakes(d.brakes);
  d.brakes.time_constant.setConstant(how.believed_lag.value_or(how.lag));
  d.start = start_beside(wall, how.gap);
  // Each further law takes a second to compile
  switch (which) {
    case law::none: return follow(d, control_of(d, ph::no_direct_control(), wall, how), wall, how);
    case law::velocity: return follow(d, control_of(d, ph::velocity_direct_control(), wall, how), wall, how);
    default: throw std::logic_error("not a law of the XY table");
  }
}

}  // namespace experiments
