/// @file
/// What a controller takes and returns in Python, for a device of any size.
#pragma once

#include <passive_haptics_python/from_python.hpp>

#include <passive_haptics/control/step_result.hpp>

#include <cstring>
#include <optional>
#include <vector>

namespace passive_haptics_python {

/// A vector whose length is that of a device.
using numbers = Eigen::VectorXd;

/// The value of an enumeration as the IntEnum of the package.
template <class E>
py::object enumerated(const char* name, E value) {
  return py::module_::import("passive_haptics.results").attr(name)(int(value));
}

/// Whether two vectors have the same bits, so that a NaN equals itself.
inline bool same_bits(const numbers& a, const numbers& b) {
  return a.size() == b.size() &&
         (a.size() == 0 || std::memcmp(a.data(), b.data(), std::size_t(a.size()) * sizeof(double)) == 0);
}
/// Whether two numbers have the same bits.
inline bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// State of a device.
struct state_values {
  double time = 0;                    ///< [s]
  numbers q;                          ///< [rad or m]
  numbers qd;                         ///< [rad/s or m/s]
  std::optional<numbers> hand_force;  ///< [N], base frame; none without a force sensor.
};

/// This vector of a state as N numbers; a ValueError if it has others.
template <int N>
ph::vector<double, N> sized(const numbers& v, const char* name, const char* of) {
  if (v.size() != N)
    refuse_value(std::string("length of ") + name + " = " + std::to_string(v.size()) + ", expected " +
                 std::to_string(N) + ", the number of " + of);
  return v;
}

/// What one control cycle decides: step_result of any device.
struct result_values {
  numbers capacity;                                      ///< [N m]
  numbers torque;                                        ///< [N m]
  ph::status outcome = ph::status::ok;                   ///< ok, or why not.
  ph::power_class power = ph::power_class::none;         ///< Of Fd.
  ph::display_class display = ph::display_class::exact;  ///< How Fd is displayed.
  bool saturated = false;                                ///< A limit was reached.
  int wall_number = -1;                                  ///< -1 in free space.
  double alpha = 1;                                      ///< (12)
  double approximation_cosine = 1;                       ///< cos(gamma)
  numbers desired_force;                                 ///< Fd [N]
  numbers control_force;                                 ///< Fc [N]
  numbers cone_coefficients;                             ///< [N m]
  numbers signs;                                         ///< s
  numbers settled_signs;                                 ///< s*; empty where nothing settles.
  numbers settled_velocity;                              ///< v' [m/s]; empty where nothing settles.
  std::vector<ph::contact_report<double>> contacts;      ///< Each touched wall.
};

/// The values of a step_result, with the reports of touched walls if the scene has several.
template <class R>
result_values values_of(const R& r) {
  result_values v{r.capacity,
                  r.torque,
                  r.outcome,
                  r.power,
                  r.display,
                  r.saturated,
                  r.wall_number,
                  r.alpha,
                  r.approximation_cosine,
                  r.desired_force,
                  r.control_force,
                  r.cone_coefficients,
                  r.signs,
                  {},
                  {},
                  {}};
  if constexpr (requires { r.settled_signs; }) {
    v.settled_signs = r.settled_signs;
    v.settled_velocity = r.settled_velocity;
  }
  if constexpr (requires { r.contact_count; })
    v.contacts.assign(r.contacts.begin(), r.contacts.begin() + r.contact_count);
  return v;
}

}  // namespace passive_haptics_python
