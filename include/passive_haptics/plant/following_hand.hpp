/// A model of a hand that moves along a wall and presses on it.
#pragma once

#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/core/parameters.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace passive_haptics {

/// Minimum time constant [s] of a mass [kg] with a spring [N/m] or a damper [N s/m].
template <class T>
T min_time_constant(T mass, T stiffness, T damping) {
  constexpr T none = std::numeric_limits<T>::infinity();
  return std::min(damping > T(0) ? mass / damping : none,
                  stiffness > T(0) ? std::sqrt(mass / stiffness) : none);
}

/// Error text if the time step of a simulation [s] exceeds the minimum time constant of hand and device [s];
/// empty otherwise. The motion becomes unstable from about twice that constant.
inline error_message check_time_step(double time_step, double fastest) {
  if (!(time_step > fastest)) return {};
  return detail::error_text("fastest time constant of hand and device [s]", fastest,
                            "at least the time step, " + detail::value_text(time_step) +
                                "; reduce the step, or use a softer hand or more mass");
}

/// Impedance of the hand along the wall and into it. The paper does not print these values; with them the
/// normal hand force stays below the paper's 2 N (Fig. 8).
template <class T>
struct following_hand_parameters {
  T speed = T(0.05);          ///< Intended speed along the wall [m/s].
  T stiffness = T(200);       ///< Along the wall [N/m].
  T damping = T(20);          ///< Along the wall [N s/m].
  T push = T(2);              ///< Force into the wall at target_depth [N].
  T normal_stiffness = T(0);  ///< Decrease of the push with depth [N/m]; 0 for a constant push.
  T target_depth = T(0);      ///< Depth at which the hand pushes with `push` [m].
  T normal_damping = T(20);   ///< Normal to the wall [N s/m].
  T mass = T(0.5);            ///< Mass that moves with the handle [kg].

  static constexpr auto members() {
    using p = following_hand_parameters;
    return member_table(member("speed", &p::speed, "m/s", range::finite),
                        member("stiffness", &p::stiffness, "N/m", range::not_negative),
                        member("damping", &p::damping, "N s/m", range::not_negative),
                        member("push", &p::push, "N", range::finite),
                        member("normal_stiffness", &p::normal_stiffness, "N/m", range::not_negative),
                        member("target_depth", &p::target_depth, "m", range::finite),
                        member("normal_damping", &p::normal_damping, "N s/m", range::not_negative),
                        member("mass", &p::mass, "kg", range::not_negative));
  }
};

/// A hand that moves along `direction` at constant speed while it presses on the wall:
///
///     F = (K (s0 + speed t - s) / max(0.3, u . t) + B (speed - v . t)) t
///         - (push + Kn (target_depth - depth) + Bn (v . n)) n
///
/// with the outward normal n, the direction u, its projection t on the wall and the progress s = u . x. Kn =
/// 0 is a constant push; with Kn > 0 the push decreases with the depth. A spatial hand also holds the handle
/// along b = n x t: - (K b . (x - x0) + B b . v) b.
template <class T, int D>
class following_hand {
 public:
  /// Starts at x0 [m] at time 0. Throws std::invalid_argument with the text of validate(p).
  following_hand(const vector<T, D>& direction, const vector<T, D>& x0,
                 const following_hand_parameters<T>& p = {})
      : p_(require_valid(p)), direction_(direction.normalized()), x0_(x0), start_(direction_.dot(x0)) {}

  /// Muscle force [N] at time [s] for handle position [m], velocity [m/s] and depth [m] in a wall of normal
  /// n.
  vector<T, D> force(T time, const vector<T, D>& x, const vector<T, D>& v, const vector<T, D>& n,
                     T depth) const {
    const vector<T, D> t = tangent(n);
    const T lag = start_ + p_.speed * time - direction_.dot(x);
    const T along =
        p_.stiffness * lag / std::max(min_cosine, t.dot(direction_)) + p_.damping * (p_.speed - v.dot(t));
    const T into = p_.push + p_.normal_stiffness * (p_.target_depth - depth) + p_.normal_damping * v.dot(n);
    vector<T, D> F = along * t - into * n;
    if constexpr (D > 2) {
      const vector<T, D> pull = p_.stiffness * (x - x0_) + p_.damping * v;
      F -= pull - t * t.dot(pull) - n * n.dot(pull);
    }
    return F;
  }

  /// Unit direction along a wall with normal n; `direction` itself if it is normal to the wall.
  vector<T, D> tangent(const vector<T, D>& n) const {
    const vector<T, D> t = direction_ - n * n.dot(direction_);
    const T length = t.norm();
    return length > rounding_tolerance<T>(D) ? vector<T, D>(t / length) : direction_;
  }

  /// Distance along `direction` at x [m].
  T progress(const vector<T, D>& x) const { return direction_.dot(x); }
  /// Minimum time constant [s] for a mass [kg].
  T min_time_constant(T mass) const {
    return passive_haptics::min_time_constant(mass, std::max(p_.stiffness / min_cosine, p_.normal_stiffness),
                                              std::max(p_.damping, p_.normal_damping));
  }
  const following_hand_parameters<T>& parameters() const { return p_; }  ///< The parameters.

 private:
  static constexpr T min_cosine = T(0.3);  // limits the compensation of the wall's slant
  following_hand_parameters<T> p_;
  vector<T, D> direction_, x0_;
  T start_;
};

}  // namespace passive_haptics
