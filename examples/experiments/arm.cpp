// Runs with the paper's device.
#include "planar_run.hpp"

namespace experiments {

std::string_view name_of(law which) {
  switch (which) {
    case law::none: return "no_direct_control";
    case law::direct: return "direct_control";
    case law::saturated: return "saturated_direct_control";
    case law::direct_dead_band: return "direct_control, dead band";
    case law::velocity: return "velocity_direct_control";
    case law::velocity_on_touch: return "velocity_direct_control, on touch";
    case law::coercive: return "coercive_force_approximation";
    case law::single_degree_of_freedom: return "single_degree_of_freedom_control";
    case law::velocity_ratio: return "velocity_ratio_control";
    case law::on_off: return "on_off_control";
    case law::bang_bang: return "bang_bang_control";
  }
  return "unknown law";
}

test_wall planar_wall(double slant) {
  return test_wall(ph::half_space<2>({0, 0.225}, {std::sin(slant), -std::cos(slant)}));
}
test_wall concave_wall() { return test_wall(ph::disc({0.11, -0.10}, 0.325, ph::filling::hollow)); }
test_wall convex_wall() { return test_wall(ph::disc({0.11, 0.55}, 0.325)); }

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
