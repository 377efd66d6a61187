/// Results of a batch, as a structure of arrays.
#pragma once

#include <passive_haptics/control/batch/batch_states.hpp>
#include <passive_haptics/control/step_result.hpp>
#include <passive_haptics/core/flatten.hpp>
#include <passive_haptics/core/nth.hpp>

#include <cstdint>

namespace passive_haptics {

/// Arrays for the members of step_result of N states. Empty arrays are skipped; if only capacity and outcome
/// are given, each cycle runs as a controller's command(). Arrays must not overlap.
template <class M>
struct batch_results {
  static_assert(is_mechanism<M, explain>());
  using T = typename M::scalar;  ///< Scalar of the results.

  component_arrays<T, M::brake_count> capacity;  ///< Maximum torque each brake may hold [N m].
  std::span<status> outcome;                     ///< ok, or why the brakes were released.

  component_arrays<T, M::brake_count> torque = {};  ///< Predicted torque on the mechanism [N m].
  std::span<power_class> power = {};                ///< Class of the desired force.
  std::span<display_class> display = {};            ///< How it is displayed.
  std::span<std::uint8_t> saturated = {};           ///< 1 if a torque limit was reached, else 0.
  std::span<int> wall_number = {};                  ///< Wall that demands the force; -1 in free space.
  std::span<T> alpha = {};                          ///< Scale factor of the law (12).
  std::span<T> approximation_cosine = {};           ///< cos(gamma).
  component_arrays<T, M::task_dimension> desired_force = {};   ///< Fd [N], base frame.
  component_arrays<T, M::task_dimension> control_force = {};   ///< Fc [N], base frame.
  component_arrays<T, M::brake_count> cone_coefficients = {};  ///< Torques of Fc [N m].
  component_arrays<T, M::brake_count> signs = {};              ///< s: -1, 0 or 1.

  /// Calls f(name, array or arrays, member of step_result) for all optional arrays.
  template <class Result, class F>
  PASSIVE_HAPTICS_PART void for_each_of_account(const Result& r, F&& f) const {
    f("torque", torque, r.torque);
    f("power", power, r.power);
    f("display", display, r.display);
    f("saturated", saturated, r.saturated);
    f("wall_number", wall_number, r.wall_number);
    f("alpha", alpha, r.alpha);
    f("approximation_cosine", approximation_cosine, r.approximation_cosine);
    f("desired_force", desired_force, r.desired_force);
    f("control_force", control_force, r.control_force);
    f("cone_coefficients", cone_coefficients, r.cone_coefficients);
    f("signs", signs, r.signs);
  }
};

namespace detail {

template <class T>
bool is_left_out(std::span<T> array) {
  return array.empty();
}
template <class T, std::size_t Components>
bool is_left_out(const std::array<std::span<T>, Components>& arrays) {
  return arrays[0].empty();
}

template <class Stored, class X>
void store(std::span<Stored> array, std::size_t k, const X& x) {
  array[k] = static_cast<Stored>(x);
}
template <class T, std::size_t Components, class X, int N>
void store(const std::array<std::span<T>, Components>& arrays, std::size_t k, const vector<X, N>& x) {
  static_assert(N == static_cast<int>(Components));
  unrolled<N>([&](auto i) { store(nth(arrays, i), k, x[i]); });
}
template <class M, class R>
void store(const batch_results<M>& results, std::size_t k, const R& r) {
  store(results.capacity, k, r.capacity);
  store(results.outcome, k, r.outcome);
  if constexpr (requires { r.torque; })
    results.for_each_of_account(r,
                                [&](const char*, const auto& arrays, const auto& x) PASSIVE_HAPTICS_INLINE {
                                  if (!is_left_out(arrays)) store(arrays, k, x);
                                });
}

}  // namespace detail

/// True if only capacity and outcome are stored.
template <class M>
bool are_commands(const batch_results<M>& results) {
  bool left_out = true;
  results.for_each_of_account(step_result<M>(), [&](const char*, const auto& arrays, const auto&) {
    left_out = left_out && detail::is_left_out(arrays);
  });
  return left_out;
}

/// Arrays for states first to first + count - 1.
template <class M>
batch_results<M> part_of(const batch_results<M>& r, std::size_t first, std::size_t count) {
  const auto part = [&](const auto& arrays) { return detail::part_of(arrays, first, count); };
  return {part(r.capacity),      part(r.outcome),       part(r.torque),
          part(r.power),         part(r.display),       part(r.saturated),
          part(r.wall_number),   part(r.alpha),         part(r.approximation_cosine),
          part(r.desired_force), part(r.control_force), part(r.cone_coefficients),
          part(r.signs)};
}

/// Error text if the lengths of the arrays do not fit this number of states, or empty.
template <class M>
error_message check_lengths(const batch_results<M>& results, std::size_t states) {
  error_message error = detail::check_lengths("capacity", results.capacity, states, false);
  if (error.empty()) error = detail::check_lengths("outcome", results.outcome, states, false);
  results.for_each_of_account(step_result<M>(), [&](const char* name, const auto& arrays, const auto&) {
    if (error.empty()) error = detail::check_lengths(name, arrays, states, true);
  });
  return error;
}

}  // namespace passive_haptics
