/// @file
/// What both two-link arms share.
#pragma once

#include "planar_arm.hpp"

#include <passive_haptics/mechanism/models/two_link.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace explorer {

/// Inverse kinematics, branches and reach of two links.
struct two_links : described {
  using joints = ph::vector<double, 2>;  ///< q

  static constexpr const char* scene = "plane:0,0.225,0,-1";  ///< Section 5.2.
  /// The handle at (0.1, 0.22) m, elbow left.
  static joints start() { return {1.7806893577270945, -1.2747394484060247}; }
  /// The branch of q.
  static ph::elbow branch_of(const joints& q) {
    return std::sin(q[1]) > 0 ? ph::elbow::right : ph::elbow::left;
  }
  /// On the branch of q.
  static ph::joint_solution<double, 2> inverse(const ph::two_link<double>& model, const joints& x,
                                               const joints& q) {
    return model.inverse(x, branch_of(q));
  }
  /// With the elbow on the other side.
  static joints flipped(const ph::two_link<double>& model, const joints& q) {
    const auto other = branch_of(q) == ph::elbow::left ? ph::elbow::right : ph::elbow::left;
    return model.inverse(model.position(q), other).q;
  }
  /// Base, elbow and handle.
  static std::array<drawing::place, 3> points(const ph::two_link<double>& model, const joints& q) {
    const auto pose = model.pose(q);
    return {drawing::place(0, 0, 0), drawing::in_plane(pose.link_1), drawing::in_plane(model.position(q))};
  }
  /// The longer link [m].
  static double max_link_length(const ph::two_link<double>& model) {
    return std::max(model.parameters().length_1, model.parameters().length_2);
  }
  /// Both links [m].
  static double reach(const ph::two_link<double>& model) {
    return model.parameters().length_1 + model.parameters().length_2;
  }
};

}  // namespace explorer
