/// A queue from a real-time loop to another process.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace passive_haptics {

/// Up to Capacity (a power of two) records from one producer to one consumer, possibly in another process
/// (shared_memory<shared_ring<...>>). Neither locks or waits; records that do not fit are counted and lost.
template <class Record, std::size_t Capacity>
class shared_ring {
  static_assert(std::is_trivially_copyable_v<Record>,
                "passive_haptics: a record is copied between processes");
  static_assert((Capacity & (Capacity - 1)) == 0, "passive_haptics: Capacity must be a power of two");
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

 public:
  /// Returns false and counts the record as lost if the queue is full.
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

  /// Returns false if the queue is empty.
  bool pop(Record& record) noexcept {
    const std::uint64_t at = popped_.load(std::memory_order_relaxed);
    if (at == pushed_.load(std::memory_order_acquire)) return false;
    record = records_[at % Capacity];
    popped_.store(at + 1, std::memory_order_release);
    return true;
  }

  /// Number of records that fitted.
  std::uint64_t pushed() const noexcept { return pushed_.load(std::memory_order_acquire); }
  /// Number of records that did not fit.
  std::uint64_t lost() const noexcept { return lost_.load(std::memory_order_relaxed); }

 private:
  // Separate cache lines for the two sides
  alignas(64) std::atomic<std::uint64_t> pushed_ = 0;
  std::atomic<std::uint64_t> lost_ = 0;
  alignas(64) std::atomic<std::uint64_t> popped_ = 0;
  alignas(64) std::array<Record, Capacity> records_{};
};

}  // namespace passive_haptics
