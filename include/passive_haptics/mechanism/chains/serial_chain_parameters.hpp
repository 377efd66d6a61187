/// Geometry of a serial chain in its zero pose: joint screws and handle.
#pragma once

#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/core/parameters.hpp>

#include <array>
#include <limits>

namespace passive_haptics {

/// Type of a joint.
enum class joint_kind {
  revolute,   ///< Rotates about its axis, q in rad.
  prismatic,  ///< Slides along its axis, q in m.
};

/// One joint of a chain in the zero pose, base frame. The default of a spatial joint is invalid.
template <class T, int D>
struct chain_joint {
  joint_kind kind = joint_kind::revolute;  ///< Revolute or prismatic.
  /// Direction, any length > 0; unused for a planar revolute joint.
  vector<T, D> axis = vector<T, D>::Zero();
  vector<T, D> point = vector<T, D>::Zero();  ///< Point on the axis [m]; unused for a prismatic joint.

  static constexpr auto members() {
    using p = chain_joint;
    return member_table(choice("kind", &p::kind, "revolute, prismatic"), member("axis", &p::axis, "1"),
                        member("point", &p::point, "m", range::anything));
  }
  /// Checks the members in use.
  error_message rules() const {
    const bool turns = kind == joint_kind::revolute;
    if (turns && D == 2) return check_value("point", point, "m", range::finite);
    return detail::first_error(check_value("axis", axis, "1", range::direction),
                               turns ? check_value("point", point, "m", range::finite) : "");
  }
};

/// Revolute joint of a planar chain at `point` [m], counterclockwise.
template <class T>
chain_joint<T, 2> revolute_joint(const vector<T, 2>& point) {
  return {joint_kind::revolute, vector<T, 2>::Zero(), point};
}

/// Revolute joint of a spatial chain, right-handed about the line along `axis` through `point` [m].
template <class T>
chain_joint<T, 3> revolute_joint(const vector<T, 3>& axis, const vector<T, 3>& point) {
  return {joint_kind::revolute, axis, point};
}

/// Prismatic joint along `axis`.
template <class T, int D>
chain_joint<T, D> prismatic_joint(const vector<T, D>& axis) {
  return {joint_kind::prismatic, axis, vector<T, D>::Zero()};
}

/// N joints from the base outwards, and the handle. For DH parameters see denavit_hartenberg.hpp.
template <class T, int N, int D>
struct serial_chain_parameters {
  std::array<chain_joint<T, D>, std::size_t(N)> joints = {};  ///< Must be set.
  /// End effector, zero pose [m]; must be set.
  vector<T, D> handle = vector<T, D>::Constant(std::numeric_limits<T>::quiet_NaN());

  static constexpr auto members() {
    using p = serial_chain_parameters;
    return member_table(member("joints", &p::joints), member("handle", &p::handle, "m", range::finite));
  }
};

/// Planar arm with revolute joints and links of these lengths [m], along x in the zero pose.
template <class T, std::size_t N>
serial_chain_parameters<T, int(N), 2> planar_arm(const std::array<T, N>& lengths) {
  serial_chain_parameters<T, int(N), 2> p;
  vector<T, 2> end = vector<T, 2>::Zero();
  for (std::size_t i = 0; i < N; ++i) {
    p.joints[i] = revolute_joint<T>(end);
    end[0] += lengths[i];
  }
  p.handle = end;
  return p;
}

}  // namespace passive_haptics
