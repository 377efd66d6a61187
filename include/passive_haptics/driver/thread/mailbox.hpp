/// @file
/// The newest value of one thread, for one other that must not wait.
#pragma once

#include <array>
#include <atomic>
#include <type_traits>

namespace passive_haptics {

/// A triple buffer: one thread puts, one other takes the newest, whole; what was not taken in time is
/// replaced. Wait-free: a few instructions on each side, whatever the other does.
template <class T>
class mailbox {
  static_assert(std::is_trivially_copyable_v<T>, "passive_haptics: a value is copied between threads");
  static_assert(std::atomic<unsigned>::is_always_lock_free);

 public:
  /// By one thread alone.
  void put(const T& value) noexcept {
    slots_[writing_].value = value;
    writing_ = handed_over_.exchange(writing_ | fresh, std::memory_order_acq_rel) & ~fresh;
  }

  /// By one other thread alone. False, and `to` stays, where none came since.
  bool take(T& to) noexcept {
    if ((handed_over_.load(std::memory_order_relaxed) & fresh) == 0) return false;
    reading_ = handed_over_.exchange(reading_, std::memory_order_acq_rel) & ~fresh;
    to = slots_[reading_].value;
    return true;
  }

 private:
  // Apart, so that the two sides do not fight for one cache line
  struct alignas(64) slot {
    T value{};
  };
  static constexpr unsigned fresh = 4;  // flag beside the number of a slot: not taken yet

  std::array<slot, 3> slots_;
  alignas(64) unsigned writing_ = 0;
  alignas(64) std::atomic<unsigned> handed_over_ = 1;
  alignas(64) unsigned reading_ = 2;
};

}  // namespace passive_haptics
