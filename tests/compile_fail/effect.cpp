#include "prelude.hpp"

#ifdef effect_in_a_scene
// error: `with_effects(scene, effect)`
const auto scene = ph::scene(honey);
#endif

#ifdef effect_without_velocity
// error: passive_haptics: each effect must model Effect, WallEffect or JointEffect
struct breeze {
  using scalar = double;
  static constexpr int dimension = 2;
  V2 force() const { return {0, 1}; }
};
const ph::with_effects scene(room, breeze());
#endif

#ifdef effect_without_a_scalar
// error: passive_haptics: each effect needs `using scalar = double;`
struct spring {
  static constexpr int dimension = 2;
  V2 force(const V2& x, const V2&, const V2&) const { return -x; }
};
const ph::with_effects scene(room, spring());
#endif

#ifdef effect_of_another_scalar
// error: passive_haptics: an effect's scalar must be the mechanism's
const ph::viscous_field<float, 2> in_float({.viscosity = ph::matrix<float, 2, 2>::Identity()});
void cycle() { run(table(), ph::brakes_of<table>(), ph::with_effects(room, in_float), ph::direct_control()); }
#endif

#ifdef effect_of_another_dimension
// error: passive_haptics: an effect's dimension must be the scene's
const ph::with_effects scene(ph::no_walls<3>(), honey);
#endif

#ifdef end_stops_of_another_mechanism
// error: passive_haptics: an effect on joints must be of as many as the mechanism has
const ph::end_stops<double, 3> stops({});
void cycle() { run(table(), ph::brakes_of<table>(), ph::with_effects(room, stops), ph::direct_control()); }
#endif

#ifdef effect_under_a_torque_law
// error: passive_haptics: with_effects needs a ScalingLaw
using law = ph::velocity_direct_control;
void cycle() { run(table(), ph::brakes_of<table>(), ph::with_effects(room, honey), law()); }
#endif

#ifdef effect_number_out_of_range
// error: passive_haptics: there is no effect with this number
const auto second = ph::with_effects(room, honey).effect<1>();
#endif
