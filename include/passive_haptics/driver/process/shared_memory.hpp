/// @file
/// A value that a process shares with those that it forks.
#pragma once

#include <sys/mman.h>

#include <new>
#include <type_traits>
#include <utility>

namespace passive_haptics {

/// One T in memory that stays shared after fork(). Throws std::bad_alloc if there is none to be had.
template <class T>
class shared_memory {
  static_assert(
      std::is_trivially_destructible_v<T>,
      "passive_haptics: give a type with a trivial destructor; no process can see who is the last to use it");

 public:
  shared_memory() {
    void* memory = mmap(nullptr, sizeof(T), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    value_ = new (memory) T;
  }
  /// The value stays where it is.
  shared_memory(shared_memory&& other) noexcept : value_(std::exchange(other.value_, nullptr)) {}
  shared_memory& operator=(shared_memory&&) = delete;
  ~shared_memory() {
    if (value_ != nullptr) munmap(value_, sizeof(T));  // of what mmap() gave it cannot fail
  }

  /// The value, the same in each process.
  T& operator*() const noexcept { return *value_; }
  /// Its address, the same in each process.
  T* operator->() const noexcept { return value_; }

 private:
  T* value_;
};

}  // namespace passive_haptics
