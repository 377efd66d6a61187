/// States of a batch, as a structure of arrays.
#pragma once

#include <passive_haptics/control/device_state.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/core/text.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace passive_haptics {

/// N numbers per component of a vector: component i of state k is arrays[i][k].
template <class T, int Components>
using component_arrays = std::array<std::span<T>, static_cast<std::size_t>(Components)>;

/// N states of M. Refers to arrays of the caller. N is the length of the arrays of q.
template <class M>
struct batch_states {
  static_assert(is_mechanism<M, explain>());
  using T = const typename M::scalar;  ///< Scalar of the states.

  component_arrays<T, M::dof> q;   ///< Joint positions [rad or m].
  component_arrays<T, M::dof> qd;  ///< Joint rates [rad/s or m/s].
  /// Force of the hand on the handle [N], base frame. Empty without a force sensor.
  component_arrays<T, M::task_dimension> hand_force = {};
  std::span<const double> time = {};  ///< [s]. Empty: 0.

  std::size_t size() const { return q[0].size(); }                ///< N.
  bool has_hand_force() const { return !hand_force[0].empty(); }  ///< True if there is a hand force.

  /// State k, 0 <= k < N, with a hand force of 0 if there is none.
  device_state<M> operator[](std::size_t k) const {
    device_state<M> s;
    s.time = time.empty() ? 0 : time[k];
    for (int i = 0; i < M::dof; ++i) {
      s.q[i] = nth(q, i)[k];
      s.qd[i] = nth(qd, i)[k];
    }
    if (has_hand_force())
      for (int i = 0; i < M::task_dimension; ++i) s.hand_force[i] = nth(hand_force, i)[k];
    return s;
  }
};

namespace detail {

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
inline error_message check_lengths(std::string_view name, const auto& array, std::size_t states,
                                   bool may_be_left_out)
  requires requires { array.size_bytes(); }
{
  return may_be_left_out && array.empty() ? error_message()
                                          : check_length(name, array.size(), states, may_be_left_out);
}
// For the arrays of a vector, of which all or none must be given.
template <class T, std::size_t Components>
error_message check_lengths(std::string_view name, const std::array<std::span<T>, Components>& arrays,
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

}  // namespace detail

namespace detail {
template <class T>
std::span<T> part_of(std::span<T> array, std::size_t first, std::size_t count) {
  return array.empty() ? array : array.subspan(first, count);
}
template <class T, std::size_t Components>
std::array<std::span<T>, Components> part_of(std::array<std::span<T>, Components> arrays, std::size_t first,
                                             std::size_t count) {
  for (auto& array : arrays) array = part_of(array, first, count);
  return arrays;
}
}  // namespace detail

/// States first to first + count - 1, e.g. for a thread.
template <class M>
batch_states<M> part_of(const batch_states<M>& s, std::size_t first, std::size_t count) {
  const auto part = [&](const auto& arrays) { return detail::part_of(arrays, first, count); };
  return {part(s.q), part(s.qd), part(s.hand_force), part(s.time)};
}

/// Error text if the lengths of the arrays differ, or empty.
template <class M>
error_message check_lengths(const batch_states<M>& states) {
  const std::size_t n = states.size();
  error_message error = detail::check_lengths("q", states.q, n, false);
  if (error.empty()) error = detail::check_lengths("qd", states.qd, n, false);
  if (error.empty()) error = detail::check_lengths("hand_force", states.hand_force, n, true);
  if (error.empty()) error = detail::check_lengths("time", states.time, n, true);
  return error;
}

/// Error text if a required hand force is missing, or empty.
template <class M>
error_message check_hand_force(const batch_states<M>& states) {
  if (states.has_hand_force() || states.size() == 0) return {};
  return detail::error_of("hand_force", [&] {
    return std::string("length of hand_force[0] = 0: expected ")
        .append(std::to_string(states.size()))
        .append(", as the law needs a hand force; or use a law that needs none (no_direct_control)");
  });
}

}  // namespace passive_haptics
