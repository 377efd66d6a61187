#include "prelude.hpp"

#ifdef limit_misspelt
// error: passive_haptics: the brakes need a torque_limit, or static constexpr bool unlimited = true.
struct brakes {
  V2 torque_limits;
};
void cycle() { run(table(), brakes(), room, ph::no_direct_control()); }
#endif

#ifdef brakes_of_wrong_size
// error: passive_haptics: torque_limit of the brakes must be a vector<scalar, brake_count> exactly
struct brakes {
  ph::vector<double, 3> torque_limit;
};
void cycle() { run(table(), brakes(), room, ph::no_direct_control()); }
#endif

#ifdef torque_dead_band_without_a_rate_dead_band
// error: passive_haptics: torque_dead_band of the brakes must be a vector<scalar, brake_count> exactly, in
// addition to a rate_dead_band
struct brakes {
  V2 torque_limit, torque_dead_band;
};
void cycle() { run(table(), brakes(), room, ph::no_direct_control()); }
#endif

#ifdef torque_lower_without_torque_upper
// error: passive_haptics: torque_lower and torque_upper of the brakes must both be a vector<scalar,
// brake_count>
struct brakes {
  V2 torque_limit, torque_lower;
};
void cycle() { run(table(), brakes(), room, ph::no_direct_control()); }
#endif

#ifdef brake_model_without_a_state
// error: passive_haptics: a brake model needs a default-constructible `struct state`
struct brake {
  using scalar = double;
  ph::brake_resistance<double> advance(double, double, double) const noexcept { return {}; }
  double torque_limit_at(double) const noexcept { return 1; }
};
static_assert(ph::is_brake_model<brake, ph::explain>());
#endif

#ifdef brake_model_that_takes_no_rate
// error: passive_haptics: a brake model needs `brake_resistance<scalar> advance(scalar dt, scalar command,
// scalar rate, state&) const noexcept`
#include <passive_haptics/plant/simulated_device.hpp>
struct brake {
  using scalar = double;
  struct state {};
  ph::brake_resistance<double> advance(double, double, state&) const noexcept { return {}; }
  double torque_limit_at(double) const noexcept { return 1; }
};
ph::simulated_device plant(table(), ph::brake_models_of<table, brake>{}, 0.5, {0, 0});
#endif

#ifdef brake_model_without_a_limit
// error: passive_haptics: a brake model needs `scalar torque_limit_at(scalar rate) const noexcept`
struct brake {
  using scalar = double;
  struct state {};
  ph::brake_resistance<double> advance(double, double, double, state&) const noexcept { return {}; }
};
static_assert(ph::is_brake_model<brake, ph::explain>());
#endif
