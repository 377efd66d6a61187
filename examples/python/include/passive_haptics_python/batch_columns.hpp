/// @file
/// The arrays of a batch as columns of any device: where numbers stand, whatever the mechanism.
#pragma once

#include <passive_haptics/control/batch/batch_controller.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace passive_haptics_python {

namespace ph = passive_haptics;

/// Where N states stand, component by component, and where their results go. Null pointers and empty lists
/// are left out.
struct batch_columns {
  std::size_t count = 0;                   ///< N
  std::vector<const double*> q;            ///< [rad or m]
  std::vector<const double*> qd;           ///< [rad/s or m/s]
  std::vector<const double*> hand_force;   ///< [N]
  const double* time = nullptr;            ///< [s]
  std::vector<double*> capacity;           ///< [N m]
  ph::status* outcome = nullptr;           ///< ok, or why not.
  std::vector<double*> torque;             ///< [N m]
  ph::power_class* power = nullptr;        ///< Of Fd.
  ph::display_class* display = nullptr;    ///< How Fd is displayed.
  std::uint8_t* saturated = nullptr;       ///< A limit was reached.
  int* wall_number = nullptr;              ///< -1 in free space.
  double* alpha = nullptr;                 ///< (12)
  double* approximation_cosine = nullptr;  ///< cos(gamma)
  std::vector<double*> desired_force;      ///< Fd [N]
  std::vector<double*> control_force;      ///< Fc [N]
  std::vector<double*> cone_coefficients;  ///< [N m]
  std::vector<double*> signs;              ///< s
};

namespace detail {

template <class T>
std::span<T> span_of(T* first, std::size_t count) {
  return first == nullptr ? std::span<T>() : std::span<T>(first, count);
}
template <int Components, class T>
ph::component_arrays<T, Components> spans_of(const std::vector<T*>& first, std::size_t count) {
  ph::component_arrays<T, Components> all = {};
  for (std::size_t i = 0; i < first.size() && i < all.size(); ++i) all[i] = span_of(first[i], count);
  return all;
}

}  // namespace detail

/// The states of mechanism M.
template <class M>
ph::batch_states<M> states_of(const batch_columns& c) {
  return {detail::spans_of<M::dof>(c.q, c.count), detail::spans_of<M::dof>(c.qd, c.count),
          detail::spans_of<M::task_dimension>(c.hand_force, c.count), detail::span_of(c.time, c.count)};
}

/// Where the results of mechanism M go.
template <class M>
ph::batch_results<M> results_of(const batch_columns& c) {
  constexpr int m = M::brake_count, d = M::task_dimension;
  const std::size_t n = c.count;
  return {detail::spans_of<m>(c.capacity, n),
          detail::span_of(c.outcome, n),
          detail::spans_of<m>(c.torque, n),
          detail::span_of(c.power, n),
          detail::span_of(c.display, n),
          detail::span_of(c.saturated, n),
          detail::span_of(c.wall_number, n),
          detail::span_of(c.alpha, n),
          detail::span_of(c.approximation_cosine, n),
          detail::spans_of<d>(c.desired_force, n),
          detail::spans_of<d>(c.control_force, n),
          detail::spans_of<m>(c.cone_coefficients, n),
          detail::spans_of<m>(c.signs, n)};
}

}  // namespace passive_haptics_python
