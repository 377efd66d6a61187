/// @file
/// Geometry of a serial chain: the screws of its joints and its handle, all in the zero pose.
#pragma once

#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/core/parameters.hpp>

#include <array>
#include <limits>

namespace passive_haptics {

/// How a joint moves.
enum class joint_kind {
  revolute,   ///< Turns about its axis, q in rad.
  prismatic,  ///< Slides along its axis, q in m.
};

/// One joint of a serial chain in the zero pose, base frame, plane (D = 2) or space (D = 3).
/// No default is a usable joint of a spatial chain: there is no usual geometry.
template <class T, int D>
struct chain_joint {
  joint_kind kind = joint_kind::revolute;  ///< Turns or slides.
  /// Direction, any length > 0; not read in a revolute planar joint.
  vector<T, D> axis = vector<T, D>::Zero();
  vector<T, D> point = vector<T, D>::Zero();  ///< On the axis [m]; not read in a prismatic joint.

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = chain_joint;
    return member_table(choice("kind", &p::kind, "revolute, prismatic"), member("axis", &p::axis, "1"),
                        member("point", &p::point, "m", range::anything));
  }
  /// Of what is read.
  error_message rules() const {
    const bool turns = kind == joint_kind::revolute;
    if (turns && D == 2) return check_value("point", point, "m", range::finite);
    return detail::first_error(check_value("axis", axis, "1", range::direction),
                               turns ? check_value("point", point, "m", range::finite) : "");
  }
};

/// Joint that turns counterclockwise in the plane about `point` [m].
template <class T>
chain_joint<T, 2> revolute_joint(const vector<T, 2>& point) {
  return {joint_kind::revolute, vector<T, 2>::Zero(), point};
}

/// Joint that turns in space, right-handed about the line along `axis` through `point` [m].
template <class T>
chain_joint<T, 3> revolute_joint(const vector<T, 3>& axis, const vector<T, 3>& point) {
  return {joint_kind::revolute, axis, point};
}

/// Joint that slides along `axis`.
template <class T, int D>
chain_joint<T, D> prismatic_joint(const vector<T, D>& axis) {
  return {joint_kind::prismatic, axis, vector<T, D>::Zero()};
}

/// N joints from the base outwards, and the handle. From DH parameters: denavit_hartenberg.hpp.
template <class T, int N, int D>
struct serial_chain_parameters {
  std::array<chain_joint<T, D>, std::size_t(N)> joints = {};  ///< No default fits.
  /// End effector, zero pose [m]; no default.
  vector<T, D> handle = vector<T, D>::Constant(std::numeric_limits<T>::quiet_NaN());

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = serial_chain_parameters;
    return member_table(member("joints", &p::joints), member("handle", &p::handle, "m", range::finite));
  }
};

/// Planar arm of revolute joints, all its links [m] along x in the zero pose; joint i turns from link i - 1.
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
