// Waiting for what has to come.
#pragma once

#include <passive_haptics/driver/clock.hpp>

#include <atomic>
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

// The result of f(), while live() is called each millisecond by another thread.
template <class F, class Live>
auto beside(Live&& live, F&& f) {
  std::atomic<bool> ended{false};
  std::thread other([&] {
    for (; !ended; std::this_thread::sleep_for(std::chrono::milliseconds(1))) live();
  });
  const auto result = f();
  ended = true;
  other.join();
  return result;
}
