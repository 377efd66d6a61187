// Runs with the paper's device.
#include "planar_run.hpp"
#include "random_plane.hpp"

namespace experiments {

run_result follow_with_arm(law which, const test_wall& wall, const setup& how) {
  using arm = ph::tendon_two_link<double>;
  device<arm> d{arm(), tendon_of(how.inertia), {}, {}, ph::encoder_parameters().resolution, {}};
  d.brakes.torque_limit.setConstant(how.limit);
  d.brakes.time_constant.setConstant(how.lag);
  d.real_brakes = ph::ideal_brakes(d.brakes);
  d.brakes.time_constant.setConstant(how.believed_lag.value_or(how.lag));
  for (ph::coulomb_brake<double>& brake : d.real_brakes) {
    brake.torque_limit = how.limit * std::max(1.0, how.gain);
    brake.gain = how.gain;
    brake.residual.strength = how.residual;
  }
  d.start = d.real.inverse(start_beside(wall, how.gap), ph::elbow::left).q;
  return follow(d, which, wall, how);
}

}  // namespace experiments
