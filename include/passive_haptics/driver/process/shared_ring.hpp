/// @file
/// A queue from a loop that must not wait to a process that may.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace passive_haptics {

/// Up to Capacity (a power of two) records from one producer to one consumer, which may be another process
/// (shared_memory<shared_ring<...>>). Neither locks or waits; what does not fit is counted and lost.
template <class Record, std::size_t Capacity>
class shared_ring {
  static_assert(std::is_trivially_copyable_v<Record>,
                "passive_haptics: a record is copied between processes");
  static_assert((Capacity & (Capacity - 1)) == 0, "passive_haptics: Capacity must be a power of two");
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

 public:
  /// False where it is full: the record is lost, and lost() one more.
  bool push(const Record& record) noexcept {
    const std::uint64_t at = pushed_.load(std::memory_order_relaxed);
    if (at - popped_.load(std::memory_order_acquire) >= Capacity) {
      lost_.fetch_add(1, std::memory_order_relaxed);
      return false;
    }
    records_[at % Capacity] = record;
    pushed_.store(at + 1, std::memory_order_release);
    return true;
  }

  /// False where there is none.
  bool pop(Record& record) noexcept {
    const std::uint64_t at = popped_.load(std::memory_order_relaxed);
    if (at == pushed_.load(std::memory_order_acquire)) return false;
    record = records_[at % Capacity];
    popped_.store(at + 1, std::memory_order_release);
    return true;
  }

  /// Records that fitted, taken or not.
  std::uint64_t pushed() const noexcept { return pushed_.load(std::memory_order_acquire); }
  /// Records that did not fit.
  std::uint64_t lost() const noexcept { return lost_.load(std::memory_order_relaxed); }

 private:
  // Apart, so that the two sides do not fight for one cache line
  alignas(64) std::atomic<std::uint64_t> pushed_ = 0;
  std::atomic<std::uint64_t> lost_ = 0;
  alignas(64) std::atomic<std::uint64_t> popped_ = 0;
  alignas(64) std::array<Record, Capacity> records_{};
};

}  // namespace passive_haptics
