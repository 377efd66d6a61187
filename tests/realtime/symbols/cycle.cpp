// One control cycle and nothing else: what its object file asks of the outside is all that a cycle can do.
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;
using device = ph::tendon_two_link<double>;
using walls = ph::held_scene<ph::scene<ph::half_space<2>, ph::disc>>;

ph::step_result<device> cycle(ph::controller<device, walls, ph::direct_control>& control,
                              const ph::device_state<device>& state) noexcept {
  return control(state);
}
