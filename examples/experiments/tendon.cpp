// Runs with the paper's device.
#include "planar_run.hpp"

namespace experiments {

run_result follow_with_arm(law which, const test_wall& wall, const setup& how) {
  using arm = ph::tendon_two_link<double>;
  ph::tendon_two_link_parameters<double> real, believed;
  auto& p = believed;
  for (double* mass : {&p.mass_1, &p.mass_2, &p.handle_mass, &p.rotor_inertia_1, &p.rotor_inertia_2})
    *mass *= how.inertia;
  device<arm> d{arm(real), arm(believed), {}, {}, ph::encoder_parameters().resolution, {}};
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
