/// @file
/// Values that are made one by one, up to a number that is known at compile time.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace passive_haptics {

/// Up to Capacity values of X; no allocation. Room that is not used costs nothing: no value is made there.
template <class X, int Capacity>
class static_vector {
  static_assert(std::is_trivially_destructible_v<X>);

 public:
  /// Empty.
  static_vector() {}
  /// A copy of each value.
  static_vector(const static_vector& other) { *this = other; }
  /// A copy of each value.
  static_vector& operator=(const static_vector& other) {
    size_ = other.size_;
    std::uninitialized_copy_n(other.data(), size_, data());
    return *this;
  }

  /// Adds a value. Fewer than Capacity must be there.
  X& append(const X& x) { return *std::construct_at(data() + size_++, x); }
  /// Empties it.
  void clear() { size_ = 0; }
  /// How many values there are.
  int size() const { return size_; }
  /// The first value.
  const X* data() const { return items_.data(); }
  /// The first value, to change it.
  X* data() { return items_.data(); }

 private:
  union {
    std::array<X, static_cast<std::size_t>(Capacity)> items_;
  };
  int size_ = 0;
};

/// At most one value, which is made in advance: the optimiser sees through it, but not through a union.
template <class X>
class static_vector<X, 1> {
 public:
  /// Sets the value. None must be there.
  X& append(const X& x) {
    item_ = x;
    size_ = 1;
    return item_;
  }
  /// Empties it.
  void clear() { size_ = 0; }
  /// 0 or 1.
  int size() const { return size_; }
  /// The value.
  const X* data() const { return &item_; }
  /// The value, to change it.
  X* data() { return &item_; }

 private:
  X item_{};
  int size_ = 0;
};

}  // namespace passive_haptics
