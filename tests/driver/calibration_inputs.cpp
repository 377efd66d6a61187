// slow
// What a calibration would not read, or cannot know, is a mistake.
#include <gtest/gtest.h>
#include <passive_haptics/driver/calibration/device_calibration.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>

#include <cmath>
#include <stdexcept>
#include <string>

namespace ph = passive_haptics;
using arm = ph::tendon_two_link<double>;

namespace {

// A default link would turn the forces of other mechanisms
TEST(calibration, refuses_a_sensor_frame_whose_link_was_not_given) {
  const auto error = [](const ph::planar_sensor_frame<2>& frame) -> std::string {
    try {
      ph::device_calibration(arm(), ph::device_calibration_parameters<arm>(), frame);
    } catch (const std::invalid_argument& wrong) {
      return wrong.what();
    }
    return "";
  };
  EXPECT_EQ(error({.link = {0, 0}}), "");
  EXPECT_EQ(
      error({}),
      "passive_haptics: link[0] [1] = nan, expected a finite number; set link to {1, 1} on the last link "
      "of a two_link or tendon_two_link, {0, 1} where q2 is measured from the base, {0, 0} where the "
      "sensor does not turn");
  EXPECT_TRUE(error({.link = {1, INFINITY}}).starts_with("passive_haptics: link[1] [1] = inf, expected"));
  EXPECT_EQ(error({.link = {1, 1}, .mounting = NAN}),
            "passive_haptics: mounting [rad] = nan, expected a finite number");
}

TEST(calibration, refuses_gravity_without_a_mass_that_it_pulls_at) {
  ph::force_calibration_parameters<2> p;
  p.gravity = {0, -9.81};
  EXPECT_EQ(validate(p),
            "handle_mass [kg] = 0, expected > 0 where gravity is given, as nothing else reads it; weigh the "
            "handle, or leave gravity out");
  p.handle_mass = 0.2;
  EXPECT_EQ(validate(p), "");
}

TEST(calibration, has_the_joint_positions_of_counts) {
  const ph::device_calibration_parameters<arm> p;
  const ph::device_calibration device(arm(), p);
  const ph::vector<double, 2> q(0.3, -0.4), counts = device.encoders.counts(device.axis_positions(q));
  EXPECT_LT((device.joint_positions({counts[0], counts[1]}) - q).norm(), 1e-12);
}

}  // namespace
