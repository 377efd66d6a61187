// Every enumerator has words of its own.
#include <passive_haptics/core/status.hpp>
#include <passive_haptics/driver/calibration/steady_mean.hpp>
#include <passive_haptics/driver/safe_port_parameters.hpp>
#include <passive_haptics/force/classification.hpp>

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <string_view>

namespace ph = passive_haptics;

namespace {

// The enumerators count from 0: words for each, none twice, and `otherwise` beyond the last.
template <class Enum>
void expect_words(int count, std::string_view otherwise) {
  std::set<std::string> seen;
  for (int i = 0; i < count; ++i) {
    const std::string words(to_string(static_cast<Enum>(i)));
    EXPECT_NE(words, otherwise) << "enumerator " << i;
    EXPECT_FALSE(words.empty()) << "enumerator " << i;
    EXPECT_TRUE(seen.insert(words).second) << words << " stands for two enumerators";
  }
  EXPECT_EQ(to_string(static_cast<Enum>(count)), otherwise);
  EXPECT_EQ(to_string(static_cast<Enum>(-1)), otherwise);
}

TEST(enumerations, have_words_for_each_enumerator) {
  expect_words<ph::status>(static_cast<int>(ph::status::time_not_rising) + 1, "unknown status");
  expect_words<ph::power_class>(static_cast<int>(ph::power_class::passive_2) + 1, "unknown power class");
  expect_words<ph::display_class>(static_cast<int>(ph::display_class::exact) + 1, "unknown display class");
  expect_words<ph::fault>(static_cast<int>(ph::fault::user) + 1, "unknown fault");
  expect_words<ph::port_status>(static_cast<int>(ph::port_status::failed) + 1, "unknown port status");
  expect_words<ph::port_state>(static_cast<int>(ph::port_state::released) + 1, "unknown state");
  expect_words<ph::steady_status>(static_cast<int>(ph::steady_status::done) + 1, "unknown steady status");
}

// Those that are shown to the user of a device, one of each enumeration.
TEST(enumerations, have_the_right_words) {
  EXPECT_EQ(to_string(ph::status::ok), "ok");
  EXPECT_EQ(to_string(ph::status::result_not_finite), "overflow");
  EXPECT_EQ(to_string(ph::status::scene_stale), "the scene is out of date");
  EXPECT_EQ(to_string(ph::power_class::passive_1), "passive I");
  EXPECT_EQ(to_string(ph::display_class::approximate), "approximate");
  EXPECT_EQ(to_string(ph::fault::none), "no fault");
  EXPECT_EQ(to_string(ph::fault::device_restarted), "the device restarted");
  EXPECT_EQ(to_string(ph::fault::law_failed), "the control law failed");
  EXPECT_EQ(to_string(ph::port_status::bad_sample), "damaged sample");
  EXPECT_EQ(to_string(ph::port_state::degraded), "degraded");
  EXPECT_EQ(to_string(ph::steady_status::moved), "moved: started again");
}

TEST(enumerations, have_words_for_each_place_of_a_fault) {
  using enum ph::fault_source;
  EXPECT_EQ(to_string(ph::fault_record{ph::fault::user, loop, -1}), "as requested");
  EXPECT_EQ(to_string(ph::fault_record{ph::fault::device_lost, encoders, -1}), "encoders: device lost");
  EXPECT_EQ(to_string(ph::fault_record{ph::fault::encoder_jump, encoders, 1}), "encoder 2: jumped");
  EXPECT_EQ(to_string(ph::fault_record{ph::fault::sample_missing, force_sensor, -1}),
            "force sensor: no sample");
  EXPECT_EQ(to_string(ph::fault_record{ph::fault::sensor_saturated, force_sensor, 0}),
            "force channel 1: saturated");
  EXPECT_EQ(to_string(ph::fault_record{ph::fault::write_refused, brakes, -1}),
            "brakes: the device rejects currents");
  EXPECT_EQ(to_string(ph::fault_record{ph::fault::user, brakes, 2}), "brake 3: as requested");
}

}  // namespace
