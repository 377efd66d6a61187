/// A value shared with forked processes.
#pragma once

#include <sys/mman.h>

#include <new>
#include <type_traits>
#include <utility>

namespace passive_haptics {

/// One T in memory that stays shared after fork(). Throws std::bad_alloc.
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
  /// Keeps the address of the value.
  shared_memory(shared_memory&& other) noexcept : value_(std::exchange(other.value_, nullptr)) {}
  shared_memory& operator=(shared_memory&&) = delete;
  ~shared_memory() {
    if (value_ != nullptr) munmap(value_, sizeof(T));  // cannot fail for memory of mmap()
  }

  T& operator*() const noexcept { return *value_; }  ///< The value.
  T* operator->() const noexcept { return value_; }  ///< Address of the value, equal in each process.

 private:
  T* value_;
};

}  // namespace passive_haptics
