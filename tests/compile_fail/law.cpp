#include "prelude.hpp"

#ifdef law_that_may_throw
// error: passive_haptics: the law must model ControlLaw: give it `template <class T, int D> T scale(const
// contact_situation<T, D>&) const noexcept`
struct law {
  template <class T, int D>
  T scale(const ph::contact_situation<T, D>&) const {
    return 1;
  }
};
void cycle() { run(device(), ph::brakes_of<device>(), room, law()); }
#endif

#ifdef law_without_its_hand_force
// error: passive_haptics: this law needs a hand force: give the state a hand_force
using state = ph::sensorless_device_state<table>;
void cycle() { run(table(), ph::brakes_of<table>(), room, ph::direct_control(), state()); }
#endif

#ifdef law_without_dynamics
// error: passive_haptics: this law needs a mechanism that models Dynamics: give it mass_matrix
void cycle() { run(device(), ph::brakes_of<device>(), room, ph::velocity_direct_control()); }
#endif

#ifdef law_without_its_brake_lag
// error: passive_haptics: this law needs the brakes' lag: give the brakes a time_constant
void cycle() { run(table(), ph::unlimited_brakes(), room, ph::velocity_direct_control()); }
#endif

#ifdef torque_law_of_other_brakes
// error: passive_haptics: torque() of this law accepts only brakes_of<M>
struct law {
  static constexpr bool commands_torques = true;
  struct memory {};
  template <class M, class E, int D, int N>
  ph::brake_vector<M> torque(const ph::brake_situation<M, E>& now, const ph::contacts<D, N>&, memory&) const {
    return -now.s;
  }
};
void cycle() { run(table(), ph::unlimited_brakes(), room, law()); }
#endif

#ifdef saturated_law_at_several_walls
// error: passive_haptics: a law that saturates before scaling takes one wall at a time
const ph::wall wall(plane);
void cycle() { run(table(), ph::brakes_of<table>(), ph::scene(wall, wall), ph::saturated_direct_control()); }
#endif

#ifdef lag_of_too_many_brakes
// error: passive_haptics: brake_lag_model is for at most 12 brakes.
void cycle() { ph::brake_lag_model().advance(0, ph::vector<double, 13>()); }
#endif
