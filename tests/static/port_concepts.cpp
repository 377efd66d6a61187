// Ports and force sensors: what fits, and what only looks like it.
#include <passive_haptics/driver/port.hpp>

namespace ph = passive_haptics;

namespace {

struct complete_port {
  static constexpr int encoder_count = 1, brake_count = 2;
  std::string open();
  ph::port_status read(ph::port_sample<1>&) noexcept;
  ph::port_status write(const ph::brake_currents<2>&) noexcept;
  void release() noexcept;
};
static_assert(ph::BrakePort<complete_port>);

struct port_of_negative_size : complete_port {
  static constexpr int brake_count = -1;
};
struct port_of_other_samples : complete_port {
  ph::port_status read(ph::port_sample<2>&) noexcept;
};
struct port_whose_write_may_throw : complete_port {
  ph::port_status write(const ph::brake_currents<2>&);
};
struct port_of_other_currents : complete_port {
  ph::port_status write(const ph::brake_currents<1>&) noexcept;
};
struct port_whose_release_may_throw : complete_port {
  void release();
};
static_assert(!ph::BrakePort<port_of_negative_size> && !ph::BrakePort<int>);
static_assert(!ph::BrakePort<port_of_other_samples> && !ph::BrakePort<port_whose_write_may_throw> &&
              !ph::BrakePort<port_of_other_currents> && !ph::BrakePort<port_whose_release_may_throw>);

struct complete_sensor {
  static constexpr int channel_count = 6;
  std::string open();
  ph::port_status read(ph::port_sample<6>&) noexcept;
};
struct sensor_that_says_nothing : complete_sensor {
  void open();
};
struct sensor_whose_read_may_throw : complete_sensor {
  ph::port_status read(ph::port_sample<6>&);
};
static_assert(ph::ForceSensor<complete_sensor> && ph::ForceSensor<ph::no_force_sensor>);
static_assert(!ph::ForceSensor<sensor_that_says_nothing> && !ph::ForceSensor<sensor_whose_read_may_throw> &&
              !ph::ForceSensor<complete_port>);

}  // namespace
