#include <passive_haptics/interop/chai3d.hpp>
#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/following_hand.hpp>
#include <passive_haptics/plant/simulated_device.hpp>

#include <algorithm>
#include <cstdio>

namespace ph = passive_haptics;
using device = ph::tendon_two_link<double>;

struct simulated_arm {
  ph::simulated_device<device>* plant;
  ph::following_hand<double, 2> hand{{1, 0}, plant->position()};
  double time = 0;  // [s]

  ph::device_state<device> measure() noexcept {
    return {time, plant->q(), plant->qd(), plant->sensed_force()};
  }
  void command(const ph::brake_vector<device>& capacity) noexcept {
    for (int i = 0; i < 10; ++i, time += 1e-4) {  // one millisecond
      const ph::point<2> x = plant->position();
      const double depth = x[1] - 0.225;
      plant->advance(1e-4, capacity, hand.force(time, x, plant->velocity(), {0, -1}, depth));
    }
  }
};

int main() {
  const device arm;
  const ph::brakes_of<device> brakes;
  ph::simulated_device<device> plant(arm, brakes, 0.5, arm.inverse({0.03, 0.22}, ph::elbow::left).q);

  const chai3d::cGenericHapticDevicePtr haptic_device(
      new ph::chai3d_device(arm, brakes, ph::velocity_direct_control(), simulated_arm{&plant},
                            {.stiffness = 2e4, .centre = {0, 0.22}}));
  if (!haptic_device->open()) return 1;

  const double stiffness = haptic_device->getSpecifications().m_maxLinearStiffness;
  double max_depth = 0;
  for (int k = 0; k < 2500; ++k) {
    chai3d::cVector3d position;
    haptic_device->getPosition(position);
    const double depth = -0.005 - position(0);  // the wall is 5 mm ahead of the centre
    haptic_device->setForce(chai3d::cVector3d(stiffness * std::max(depth, 0.0), 0, 0));
    max_depth = std::max(max_depth, depth);
  }
  haptic_device->close();
  std::printf("%.0f mm along the wall, at most %.1f mm deep\n", 1e3 * (plant.position()[0] - 0.03),
              1e3 * max_depth);
  return max_depth < 0.003 ? 0 : 1;
}
