// Control cycles behind a C interface: their object file shows what they call.
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

template <class M, class L>
using control = ph::controller<M, ph::held_scene<ph::static_scene<ph::half_space<2>, ph::disc>>, L>;

using arm = ph::tendon_two_link<double>;
using table = ph::xy_table<float>;

extern "C" void cycle_of_the_tendon_device(control<arm, ph::direct_control>& control,
                                           const ph::device_state<arm>& state, ph::step_result<arm>& result) {
  result = control(state);
}

extern "C" void cycle_of_the_table(control<table, ph::no_direct_control>& control,
                                   const ph::sensorless_device_state<table>& state,
                                   ph::step_result<table>& result) {
  result = control(state);
}

extern "C" void cycle_in_a_world_of_another_thread(
    ph::controller<table, ph::latest_scene<ph::world<2>>, ph::direct_control>& control,
    const ph::device_state<table>& state, ph::brake_command<table>& command) {
  command = control.command(state);
}
