// The loop and its port allocate nothing; tests/driver/system_calls.cpp has the ports to real devices.
#include "../realtime/allocations.hpp"

#include "fake_device.hpp"

#include <passive_haptics/driver/control_loop.hpp>

namespace {

TEST(no_allocation, between_the_ends_of_a_control_loop) {
  namespace ph = passive_haptics;
  ph::control_loop loop;
  int k = 0;
  long before = 0, counted = -1;
  loop.run(
      [&](const ph::loop_cycle&) {
        if (k == 0) before = allocations;
        counted = allocations - before;
        return ++k < 20;
      },
      [] { return false; }, [](ph::fault) {});
  EXPECT_EQ(counted, 0);
}

TEST(no_allocation, in_a_safe_port_with_good_samples_with_a_fault_and_once_rearmed) {
  fake::rig r;
  r.hold();
  const std::function<void(fake::rig&)> nothing = [](auto&) {},
                                        spoil = [](auto& s) { s.sample.value[0] = NAN; };
  EXPECT_EQ(allocations_in([&] {
              for (int k = 0; k < 100; ++k) r.cycle(k < 50 ? nothing : spoil);
              r.port.rearm();
              r.cycle();
            }),
            0);
}

}  // namespace
