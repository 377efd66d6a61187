/// Exchange of the latest value between two threads.
#pragma once

#include <array>
#include <atomic>
#include <type_traits>

namespace passive_haptics {

/// A wait-free triple buffer: one thread puts values, one other takes the latest; older ones are replaced.
template <class T>
class mailbox {
  static_assert(std::is_trivially_copyable_v<T>, "passive_haptics: a value is copied between threads");
  static_assert(std::atomic<unsigned>::is_always_lock_free);

 public:
  /// Only for the producer.
  void put(const T& value) noexcept {
    slots_[writing_].value = value;
    writing_ = handed_over_.exchange(writing_ | fresh, std::memory_order_acq_rel) & ~fresh;
  }

  /// Only for the consumer. Returns false and leaves `to` if there is no new value.
  bool take(T& to) noexcept {
    if ((handed_over_.load(std::memory_order_relaxed) & fresh) == 0) return false;
    reading_ = handed_over_.exchange(reading_, std::memory_order_acq_rel) & ~fresh;
    to = slots_[reading_].value;
    return true;
  }

 private:
  // Separate cache lines for the two sides
  struct alignas(64) slot {
    T value{};
  };
  static constexpr unsigned fresh = 4;  // flag of a slot that was not taken yet

  std::array<slot, 3> slots_;
  alignas(64) unsigned writing_ = 0;
  alignas(64) std::atomic<unsigned> handed_over_ = 1;
  alignas(64) unsigned reading_ = 2;
};

}  // namespace passive_haptics
