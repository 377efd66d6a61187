/// @file
/// Geometry of a serial chain: the screws of its joints and its handle, all in the zero pose.
#pragma once

#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/core/validate.hpp>

#include <array>
#include <limits>
#include <string>

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
  vector<T, D> axis =
      vector<T, D>::Zero();  ///< Direction, any length > 0; not read in a revolute planar joint.
  vector<T, D> point = vector<T, D>::Zero();  ///< On the axis [m]; not read in a prismatic joint.
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
  std::array<chain_joint<T, D>, N> joints = {};  ///< No default fits.
  vector<T, D> handle = vector<T, D>::Constant(
      std::numeric_limits<T>::quiet_NaN());  ///< End effector, zero pose [m]; no default.
};

namespace detail {

/// "name[i].member"
inline std::string member_of(const char* name, int i, const char* member) {
  return std::string(name) + "[" + std::to_string(i) + "]." + member;
}

template <class T, int D>
std::string check_finite_vector(const std::string& name, const vector<T, D>& x) {
  std::string first;
  for (int i = 0; i < D && first.empty(); ++i)
    first = check_finite(name + "[" + std::to_string(i) + "]", x[i]);
  return first;
}

template <class T, int D>
std::string check_joint(int i, const chain_joint<T, D>& joint) {
  const bool turns = joint.kind == joint_kind::revolute;
  if (turns && D == 2) return check_finite_vector<T, D>(member_of("joints", i, "point [m]"), joint.point);
  return first_error(
      check_finite_vector<T, D>(member_of("joints", i, "axis [1]"), joint.axis),
      check_positive(member_of("joints", i, "axis length [1]"), joint.axis.stableNorm()),
      turns ? check_finite_vector<T, D>(member_of("joints", i, "point [m]"), joint.point) : std::string());
}

}  // namespace detail

/// What is wrong with the parameters; empty if nothing.
template <class T, int N, int D>
std::string validate(const serial_chain_parameters<T, N, D>& p) {
  std::string first;
  for (int i = 0; i < N && first.empty(); ++i) first = detail::check_joint(i, p.joints[std::size_t(i)]);
  return detail::first_error(first, detail::check_finite_vector<T, D>("handle [m]", p.handle));
}

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
