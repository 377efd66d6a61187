/// States of a batch, as a structure of arrays.
#pragma once

#include <passive_haptics/control/device_state.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/core/text.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace passive_haptics {

/// Numbers of the caller at a constant distance: an array, or a column of a matrix.
template <class T>
class strided_span {
 public:
  strided_span() = default;  ///< No numbers.
  /// All numbers of a span.
  strided_span(std::span<T> all) : first_(all.data()), size_(all.size()) {}
  /// All numbers of a contiguous range, such as a std::vector.
  template <class Range>
    requires(!std::same_as<std::remove_const_t<Range>, strided_span> &&
             std::constructible_from<std::span<T>, Range&>)
  strided_span(Range& range) : strided_span(std::span<T>(range)) {}
  /// `size` numbers, one every `stride` numbers.
  strided_span(T* first, std::size_t size, std::ptrdiff_t stride)
      : first_(first), size_(size), stride_(stride) {}

  std::size_t size() const { return size_; }  ///< N.
  bool empty() const { return size_ == 0; }   ///< True if N = 0.
  /// Number k.
  T& operator[](std::size_t k) const { return first_[static_cast<std::ptrdiff_t>(k) * stride_]; }
  /// Numbers first to first + count - 1.
  strided_span subspan(std::size_t first, std::size_t count) const {
    return {first_ + static_cast<std::ptrdiff_t>(first) * stride_, count, stride_};
  }

 private:
  T* first_ = nullptr;
  std::size_t size_ = 0;
  std::ptrdiff_t stride_ = 1;
};

/// N numbers per component of a vector: component i of state k is arrays[i][k].
template <class T, int Components>
using component_arrays = std::array<strided_span<T>, static_cast<std::size_t>(Components)>;

/// N states of a device with n joints and d task dimensions. Refers to arrays of the caller. N is the length
/// of the arrays of q.
template <class T, int n, int d>
struct batch_states_of {
  component_arrays<const T, n> q;   ///< Joint positions [rad or m].
  component_arrays<const T, n> qd;  ///< Joint rates [rad/s or m/s].
  /// Force of the hand on the handle [N], base frame. Empty without a force sensor.
  component_arrays<const T, d> hand_force = {};
  strided_span<const double> time = {};  ///< [s]. Empty: 0.

  std::size_t size() const { return q[0].size(); }                ///< N.
  bool has_hand_force() const { return !hand_force[0].empty(); }  ///< True if there is a hand force.
};

/// N states of M.
template <class M>
using batch_states = batch_states_of<typename M::scalar, M::dof, M::task_dimension>;

namespace detail {

// State k, 0 <= k < N, with a hand force of 0 if there is none.
template <class M>
device_state<M> state_of(const batch_states<M>& states, std::size_t k) {
  device_state<M> s;
  s.time = states.time.empty() ? 0 : states.time[k];
  for (int i = 0; i < M::dof; ++i) {
    s.q[i] = nth(states.q, i)[k];
    s.qd[i] = nth(states.qd, i)[k];
  }
  if (states.has_hand_force())
    for (int i = 0; i < M::task_dimension; ++i) s.hand_force[i] = nth(states.hand_force, i)[k];
  return s;
}

// Error text if the length of a possibly optional array is wrong, or empty.
inline error_message check_length(std::string_view name, std::size_t length, std::size_t states,
                                  bool may_be_left_out) {
  if (length == states) return {};
  return error_of("the length of an array", [&] {
    std::string text("length of ");
    text.append(name).append(" = ").append(std::to_string(length)).append(": expected ");
    text.append(std::to_string(states)).append(", one number for each state, as q[0] has");
    if (may_be_left_out) text.append("; or leave ").append(name.substr(0, name.find('['))).append(" empty");
    return text;
  });
}
template <class T>
error_message check_lengths(std::string_view name, const strided_span<T>& array, std::size_t states,
                            bool may_be_left_out) {
  return may_be_left_out && array.empty() ? error_message()
                                          : check_length(name, array.size(), states, may_be_left_out);
}
// For the arrays of a vector, of which all or none must be given.
template <class T, std::size_t Components>
error_message check_lengths(std::string_view name, const std::array<strided_span<T>, Components>& arrays,
                            std::size_t states, bool may_be_left_out) {
  bool is_there = !may_be_left_out;
  for (const auto& array : arrays) is_there = is_there || !array.empty();
  for (std::size_t i = 0; is_there && i < Components; ++i) {
    const std::string component = std::string(name).append("[").append(std::to_string(i)).append("]");
    error_message error = check_length(component, arrays[i].size(), states, may_be_left_out);
    if (!error.empty()) return error;
  }
  return {};
}

template <class T>
strided_span<T> part_of(strided_span<T> array, std::size_t first, std::size_t count) {
  return array.empty() ? array : array.subspan(first, count);
}
template <class T, std::size_t Components>
std::array<strided_span<T>, Components> part_of(std::array<strided_span<T>, Components> arrays,
                                                std::size_t first, std::size_t count) {
  for (auto& array : arrays) array = part_of(array, first, count);
  return arrays;
}

}  // namespace detail

/// States first to first + count - 1, e.g. for a thread.
template <class T, int n, int d>
batch_states_of<T, n, d> part_of(const batch_states_of<T, n, d>& s, std::size_t first, std::size_t count) {
  const auto part = [&](const auto& arrays) { return detail::part_of(arrays, first, count); };
  return {part(s.q), part(s.qd), part(s.hand_force), part(s.time)};
}

/// Error text if the lengths of the arrays differ, or empty.
template <class T, int n, int d>
error_message check_lengths(const batch_states_of<T, n, d>& states) {
  const std::size_t size = states.size();
  error_message error = detail::check_lengths("q", states.q, size, false);
  if (error.empty()) error = detail::check_lengths("qd", states.qd, size, false);
  if (error.empty()) error = detail::check_lengths("hand_force", states.hand_force, size, true);
  if (error.empty()) error = detail::check_lengths("time", states.time, size, true);
  return error;
}

/// Error text if a required hand force is missing, or empty.
template <class T, int n, int d>
error_message check_hand_force(const batch_states_of<T, n, d>& states) {
  if (states.has_hand_force() || states.size() == 0) return {};
  return detail::error_of("hand_force", [&] {
    return std::string("length of hand_force[0] = 0: expected ")
        .append(std::to_string(states.size()))
        .append(", as the law needs a hand force; or use a law that needs none (no_direct_control)");
  });
}

}  // namespace passive_haptics
