// Waiting for what has to come.
#pragma once

#include <passive_haptics/driver/clock.hpp>

#include <chrono>
#include <thread>

// Whether it came; the time-out is for a test that has failed.
template <class F>
bool eventually(F&& f) {
  const double end = passive_haptics::monotonic_seconds() + 20;
  while (!f()) {
    if (passive_haptics::monotonic_seconds() > end) return false;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  return true;
}
