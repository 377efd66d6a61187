// slow
#include "../realtime/allocations.hpp"

#include <gtest/gtest.h>
#include <passive_haptics/driver/calibration/device_calibration.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>

namespace ph = passive_haptics;
using arm = ph::tendon_two_link<double>;

namespace {

TEST(calibration, allocates_nothing_in_the_loop) {
  ph::device_calibration_parameters<arm, 6> p;
  ph::device_calibration device(arm(), p, ph::planar_sensor_frame<2>{.link = {1, 1}});
  ph::homing<2> home(device.encoders, device.axis_positions({0, 1}));
  double sum = 0;
  const long count = allocations_in([&] {
    for (int k = 0; k < 1000; ++k) {
      const double t = 1e-3 * k;
      const auto state = device.state(t, {1.0 * k, -2.0 * k}, {1, 2, 3, 4, 5, 6});
      home.add(t, {1.0 * k, -2.0 * k});
      sum += state.hand_force[0] + device.currents({0.001 * k, 0.5})[0] + home.zero_count()[0];
      sum += device.force.tare_of({1, 2, 3, 4, 5, 6}, device.sensor_frame(state.q))[0];
    }
  });
  EXPECT_EQ(count, 0) << sum;
}

}  // namespace
