// together
// What a sequence number tells, at every distance from the last one that could overflow.
#include <gtest/gtest.h>
#include <passive_haptics/driver/checks/sample_check.hpp>

namespace {

namespace ph = passive_haptics;

ph::fault after_a_jump_of(std::uint32_t jump, std::uint32_t from) {
  ph::sample_check<1> check(0.02);
  ph::port_sample<1> s{1.0, from, {0}, {true}};
  EXPECT_EQ(check(ph::port_status::ok, s, 1.0, ph::fault_source::encoders).what, ph::fault::none);
  s.sequence += jump;
  return check(ph::port_status::ok, s, 1.0, ph::fault_source::encoders).what;
}

TEST(sample_check, tells_a_gap_a_repetition_and_a_restart_by_the_distance_modulo_2_to_32) {
  for (const std::uint32_t from : {0u, 5u, 0x7FFF'FFFFu, 0x8000'0000u, 0xFFFF'FFFFu}) {
    EXPECT_EQ(after_a_jump_of(0, from), ph::fault::sample_repeated) << from;
    for (const std::uint32_t ahead : {1u, 2u, 999u, 1000u})
      EXPECT_EQ(after_a_jump_of(ahead, from), ph::fault::none) << from << " + " << ahead;
    for (const std::uint32_t behind : {1u, 2u, 999u, 1000u})
      EXPECT_EQ(after_a_jump_of(0u - behind, from), ph::fault::sample_out_of_order)
          << from << " - " << behind;
    // Half of all numbers away there is no less negative one
    for (const std::uint32_t far :
         {1001u, 0x7FFF'FFFEu, 0x7FFF'FFFFu, 0x8000'0000u, 0x8000'0001u, 0u - 1001u})
      EXPECT_EQ(after_a_jump_of(far, from), ph::fault::device_restarted) << from << " + " << far;
  }
}

}  // namespace
