#pragma once

#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>

#include <kdl/chain.hpp>

#include <stdexcept>

namespace ph = passive_haptics;

inline ph::vector<double, 3> in_eigen(const KDL::Vector& v) { return {v.x(), v.y(), v.z()}; }

// The chain's N joints, and its tip as the handle. Converted once, so that no control cycle calls KDL.
template <int N>
ph::serial_chain_with_inertia<double, N, 3> chain_from_kdl(const KDL::Chain& chain) {
  if (chain.getNrOfJoints() != unsigned(N)) throw std::invalid_argument("another number of joints");
  ph::serial_chain_parameters<double, N, 3> geometry;
  ph::serial_chain_inertia<double, N, 3> inertia;
  inertia.handle_mass = 0;
  KDL::Frame root = KDL::Frame::Identity();  // of the segment, zero pose
  int moving = 0;
  for (const KDL::Segment& segment : chain.segments) {
    const KDL::Joint& joint = segment.getJoint();
    if (joint.getType() != KDL::Joint::None) {
      const KDL::Twist unit = segment.twist(0, 1);  // in the segment's root frame
      const bool turns = unit.rot.Norm() > 0;
      geometry.joints[std::size_t(moving)] = {turns ? ph::joint_kind::revolute : ph::joint_kind::prismatic,
                                              in_eigen(root.M * (turns ? unit.rot : unit.vel)),
                                              in_eigen(root * joint.JointOrigin())};
      inertia.rotor_inertia[moving++] = joint.getInertia();
    }
    root = root * segment.pose(0);
    KDL::RigidBodyInertia body = root.M * segment.getInertia();  // about the tip, in the axes of the base
    if (body.getMass() == 0 || moving == 0) continue;
    const KDL::Vector to_centre = body.getCOG();
    const KDL::RotationalInertia about = body.RefPoint(to_centre).getRotationalInertia();
    const Eigen::Matrix3d moments = Eigen::Map<const Eigen::Matrix3d>(about.data);
    const ph::link_inertia<double, 3> link{body.getMass(), in_eigen(root.p + to_centre),
                                           (moments + moments.transpose()) / 2};
    auto& all = inertia.links[std::size_t(moving - 1)];
    all = all.mass > 0 ? ph::joined(all, link) : link;
  }
  geometry.handle = in_eigen(root.p);
  return {geometry, inertia};
}
