#include "prelude.hpp"

#ifdef simulated_device_without_its_header
// error: passive_haptics: simulated_device needs #include <passive_haptics/plant/simulated_device.hpp>
ph::simulated_device<table> plant(table(), {}, 0.5, {0, 0});
#endif

#ifdef simulated_device_with_swapped_arguments
// error: passive_haptics: the arguments of a simulated_device are (mechanism, brakes,
// hand_mass, q), in this order
#include <passive_haptics/plant/simulated_device.hpp>
ph::simulated_device plant(table(), ph::brakes_of<table>(), V2(0, 0), 0.5);
#endif

#ifdef plant_without_dynamics
// error: passive_haptics: a simulated device needs a mechanism that models Dynamics
#include <passive_haptics/plant/simulated_device.hpp>
ph::simulated_device<device> plant(device(), ph::brakes_of<device>(), 0, {0, 0});
#endif

#ifdef plant_without_readings
// error: passive_haptics: a plant needs the readings of moving_device
#include <passive_haptics/plant/wall_following.hpp>
struct plant {
  table tool;
  const table& mechanism() const { return tool; }
  void advance(double, const V2&, const V2&) {}
} moved;
void follow(const ph::following_hand<double, 2>& hand) {
  ph::follow_wall(moved, [](const ph::device_state<table>&) { return ph::step_result<table>(); }, plane, hand,
                  {});
}
#endif

#ifdef port_that_may_throw
// error: passive_haptics: a port needs `port_status read(port_sample<encoder_count>&) noexcept`
#include <passive_haptics/driver/safe_port.hpp>
struct port {
  static constexpr int encoder_count = 2, brake_count = 2;
  std::string open() { return {}; }
  ph::port_status read(ph::port_sample<2>&) { return ph::port_status::ok; }
  ph::port_status write(const ph::brake_currents<2>&) { return ph::port_status::ok; }
  void release() {}
};
ph::safe_port<port> safe(port{});
#endif
