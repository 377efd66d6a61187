/// Results of a batch, as a structure of arrays.
#pragma once

#include <passive_haptics/control/batch_states.hpp>
#include <passive_haptics/control/step_result.hpp>
#include <passive_haptics/core/flatten.hpp>
#include <passive_haptics/core/nth.hpp>

#include <cstdint>

namespace passive_haptics {

/// Arrays for the members of step_result of N states of a device with m brakes and d task dimensions. Empty
/// arrays are skipped; if only capacity and outcome are given, each cycle runs as a controller's command().
/// Arrays must not overlap.
template <class T, int m, int d>
struct batch_results_of {
  component_arrays<T, m> capacity;  ///< Maximum torque each brake may hold [N m].
  strided_span<status> outcome;     ///< ok, or why the brakes were released.

  component_arrays<T, m> torque = {};             ///< Predicted torque on the mechanism [N m].
  strided_span<power_class> power = {};           ///< Class of the desired force.
  strided_span<display_class> display = {};       ///< How it is displayed.
  strided_span<std::uint8_t> saturated = {};      ///< 1 if a torque limit was reached, else 0.
  strided_span<int> wall_number = {};             ///< Wall that demands the force; -1 in free space.
  strided_span<T> alpha = {};                     ///< Scale factor of the law (12).
  strided_span<T> approximation_cosine = {};      ///< cos(gamma).
  component_arrays<T, d> desired_force = {};      ///< Fd [N], base frame.
  component_arrays<T, d> control_force = {};      ///< Fc [N], base frame.
  component_arrays<T, m> cone_coefficients = {};  ///< Torques of Fc [N m].
  component_arrays<T, m> signs = {};              ///< s: -1, 0 or 1.
};

/// Arrays for N states of M.
template <class M>
using batch_results = batch_results_of<typename M::scalar, M::brake_count, M::task_dimension>;

/// Calls f(name, array or arrays of results, the same member of each of more) for all optional members.
template <class F, class Results, class... More>
PASSIVE_HAPTICS_PART void for_each_optional(F&& f, Results& results, More&... more) {
  f("torque", results.torque, more.torque...);
  f("power", results.power, more.power...);
  f("display", results.display, more.display...);
  f("saturated", results.saturated, more.saturated...);
  f("wall_number", results.wall_number, more.wall_number...);
  f("alpha", results.alpha, more.alpha...);
  f("approximation_cosine", results.approximation_cosine, more.approximation_cosine...);
  f("desired_force", results.desired_force, more.desired_force...);
  f("control_force", results.control_force, more.control_force...);
  f("cone_coefficients", results.cone_coefficients, more.cone_coefficients...);
  f("signs", results.signs, more.signs...);
}

namespace detail {

template <class T>
bool is_left_out(const strided_span<T>& array) {
  return array.empty();
}
template <class T, std::size_t Components>
bool is_left_out(const std::array<strided_span<T>, Components>& arrays) {
  return arrays[0].empty();
}

template <class Stored, class X>
void store(const strided_span<Stored>& array, std::size_t k, const X& x) {
  array[k] = static_cast<Stored>(x);
}
template <class T, std::size_t Components, class X, int N>
void store(const std::array<strided_span<T>, Components>& arrays, std::size_t k, const vector<X, N>& x) {
  static_assert(N == static_cast<int>(Components));
  unrolled<N>([&](auto i) { store(nth(arrays, i), k, x[i]); });
}
template <class Results, class R>
void store(const Results& results, std::size_t k, const R& r) {
  store(results.capacity, k, r.capacity);
  store(results.outcome, k, r.outcome);
  if constexpr (requires { r.torque; })
    for_each_optional(
        [&](const char*, const auto& arrays, const auto& x) PASSIVE_HAPTICS_INLINE {
          if (!is_left_out(arrays)) store(arrays, k, x);
        },
        results, r);
}

}  // namespace detail

/// True if only capacity and outcome are stored.
template <class T, int m, int d>
bool are_commands(const batch_results_of<T, m, d>& results) {
  bool left_out = true;
  for_each_optional(
      [&](const char*, const auto& arrays) { left_out = left_out && detail::is_left_out(arrays); }, results);
  return left_out;
}

/// Arrays for states first to first + count - 1.
template <class T, int m, int d>
batch_results_of<T, m, d> part_of(batch_results_of<T, m, d> results, std::size_t first, std::size_t count) {
  const auto cut = [&](const char*, auto& arrays) { arrays = detail::part_of(arrays, first, count); };
  cut("capacity", results.capacity);
  cut("outcome", results.outcome);
  for_each_optional(cut, results);
  return results;
}

/// Error text if the lengths of the arrays do not fit this number of states, or empty.
template <class T, int m, int d>
error_message check_lengths(const batch_results_of<T, m, d>& results, std::size_t states) {
  error_message error = detail::check_lengths("capacity", results.capacity, states, false);
  if (error.empty()) error = detail::check_lengths("outcome", results.outcome, states, false);
  for_each_optional(
      [&](const char* name, const auto& arrays) {
        if (error.empty()) error = detail::check_lengths(name, arrays, states, true);
      },
      results);
  return error;
}

}  // namespace passive_haptics
