/// State and decision of a device of any size, without templates.
#pragma once

#include <passive_haptics/control/step_result.hpp>
#include <passive_haptics/core/error_message.hpp>
#include <passive_haptics/core/text.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <type_traits>

namespace passive_haptics::runtime {

inline constexpr int max_joints = 8;   ///< Maximum n and m of a device in a catalogue.
inline constexpr int max_reports = 4;  ///< Maximum contacts of a record, those of a spatial world.

/// n, d and m.
struct device_sizes {
  int dof = 0;             ///< n
  int task_dimension = 0;  ///< d
  int brake_count = 0;     ///< m
  /// True for equal sizes.
  friend bool operator==(const device_sizes&, const device_sizes&) = default;
};

/// Throws std::invalid_argument for another number than expected.
inline void require_count(const char* what, std::ptrdiff_t given, int expected) {
  if (given != expected)
    require_no_error(detail::error_text(std::string("number of ") + what, given, std::to_string(expected)));
}

/// Up to Max numbers without allocation.
template <int Max>
struct few_numbers {
  std::array<double, static_cast<std::size_t>(Max)> values{};  ///< The first `count` are used.
  int count = 0;                                               ///< Number of values.

  few_numbers() = default;
  /// Copies a vector.
  template <class V>
    requires requires(const V& v) { v.data(), v.size(); }
  explicit few_numbers(const V& v) : count(static_cast<int>(v.size())) {
    for (int i = 0; i < count; ++i) values[static_cast<std::size_t>(i)] = static_cast<double>(v.data()[i]);
  }

  std::size_t size() const { return static_cast<std::size_t>(count); }   ///< Number of values.
  const double* data() const { return values.data(); }                   ///< The first one.
  double operator[](std::size_t i) const { return values[i]; }           ///< Number i.
  operator std::span<const double>() const { return {data(), size()}; }  ///< All numbers.
  /// True for equal numbers.
  friend bool operator==(const few_numbers& a, const few_numbers& b) {
    return std::equal(a.data(), a.data() + a.count, b.data(), b.data() + b.count);
  }
};
using joint_numbers = few_numbers<max_joints>;  ///< n or m numbers.
using task_numbers = few_numbers<3>;            ///< d numbers.

/// Input of a cycle.
struct state_view {
  double time = 0;                     ///< [s]
  std::span<const double> q;           ///< n joint positions [rad or m].
  std::span<const double> qd;          ///< n joint rates [rad/s or m/s].
  std::span<const double> hand_force;  ///< d components [N], base frame; empty without a force sensor.
};

/// step_result of any device, with equal names. Trivially copyable, for exchange between processes.
struct cycle_record {
  joint_numbers capacity;                                      ///< m [N m].
  joint_numbers torque;                                        ///< m [N m].
  status outcome = status::ok;                                 ///< ok, or the reason for the release.
  power_class power = power_class::none;                       ///< As in step_result.
  display_class display = display_class::exact;                ///< As in step_result.
  bool saturated = false;                                      ///< As in step_result.
  int wall_number = -1;                                        ///< As in step_result.
  double alpha = 1;                                            ///< As in step_result.
  double approximation_cosine = 1;                             ///< As in step_result.
  task_numbers desired_force;                                  ///< d [N].
  task_numbers control_force;                                  ///< d [N].
  joint_numbers cone_coefficients;                             ///< m [N m].
  joint_numbers signs;                                         ///< m
  joint_numbers settled_signs;                                 ///< m; empty if nothing settles (n = d).
  task_numbers settled_velocity;                               ///< d [m/s]; empty if nothing settles.
  std::array<contact_report<double>, max_reports> contacts{};  ///< The first contact_count are valid.
  int contact_count = 0;                                       ///< Touched walls.

  cycle_record() = default;
  /// A step_result of any mechanism.
  template <class Result>
    requires requires(const Result& r) { r.approximation_cosine; }
  explicit cycle_record(const Result& r)
      : capacity(r.capacity),
        torque(r.torque),
        outcome(r.outcome),
        power(r.power),
        display(r.display),
        saturated(r.saturated),
        wall_number(r.wall_number),
        alpha(static_cast<double>(r.alpha)),
        approximation_cosine(static_cast<double>(r.approximation_cosine)),
        desired_force(r.desired_force),
        control_force(r.control_force),
        cone_coefficients(r.cone_coefficients),
        signs(r.signs) {
    if constexpr (requires { r.settled_signs; }) {
      settled_signs = joint_numbers(r.settled_signs);
      settled_velocity = task_numbers(r.settled_velocity);
    }
    if constexpr (requires { r.contact_count; }) {
      static_assert(std::tuple_size_v<decltype(r.contacts)> <= max_reports);
      contact_count = r.contact_count;
      std::copy_n(r.contacts.begin(), contact_count, contacts.begin());
    }
  }

  /// gamma [rad]; pi/2 if nothing is displayed.
  double approximation_angle() const { return std::acos(std::min(approximation_cosine, 1.0)); }
};
static_assert(std::is_trivially_copyable_v<cycle_record>);

}  // namespace passive_haptics::runtime
