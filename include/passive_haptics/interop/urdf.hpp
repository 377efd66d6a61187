/// @file
/// Serial chains from URDF files, by urdfdom (https://github.com/ros/urdfdom, Debian: liburdfdom-dev). Link
/// urdfdom_model and console_bridge.
#pragma once

#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>
#include <passive_haptics/scene/files/file_bytes.hpp>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <console_bridge/console.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace passive_haptics {

/// Treatment of an inertia that no rigid body has, with a principal moment above the sum of the other two.
/// Real files contain them.
enum class urdf_inertia {
  as_given,  ///< Is an error, which states the excess.
  balanced,  ///< The two smaller moments are raised until their sum is the largest; listed in remarks.
};

/// Choices of read_urdf and chain_from_urdf.
struct urdf_options {
  vector<double, 3> tool = vector<double, 3>::Zero();  ///< The handle in the frame of the tip link [m].
  /// In the frame of the base link [m/s^2]; zero: horizontal or counterbalanced.
  vector<double, 3> gravity = vector<double, 3>::Zero();
  urdf_inertia inertia = urdf_inertia::as_given;  ///< For links that no rigid body can be.
};

/// A moving joint of a URDF, with the bodies up to the next one.
struct urdf_joint {
  std::string name;              ///< In the file.
  chain_joint<double, 3> joint;  ///< In the zero pose, frame of the base link.
  link_inertia<double, 3> link;  ///< All that moves with it as one body, likewise.
  double lower = 0;              ///< [rad or m]; -infinity of a continuous joint.
  double upper = 0;              ///< [rad or m]; infinity of a continuous joint.
  double velocity = 0;           ///< [rad/s or m/s], as in the file.
  /// [N m or N], as in the file, where it may be 0, 1000 or 50 000. It is reported only: the torque limits of
  /// your brakes are those of brakes_of.
  double effort = 0;
};

/// A serial chain of a URDF with any number of joints.
struct urdf_chain {
  std::string name;                                       ///< "URDF arm.urdf", for messages.
  std::vector<urdf_joint> joints;                         ///< From the base outwards.
  vector<double, 3> handle = vector<double, 3>::Zero();   ///< Zero pose, frame of the base link [m].
  vector<double, 3> gravity = vector<double, 3>::Zero();  ///< As in the options.
  /// A line for each inertia that was balanced and each joint next to the chain that was left out; empty if
  /// there is none.
  std::string remarks;
};

namespace detail {

[[noreturn]] inline void fail_urdf(std::string_view name, const std::string& error) {
  require_no_error(printable(std::string(name).append(": ").append(error)));
  std::abort();  // not reached
}

/// Keeps what urdfdom reports about a file, which it else writes to stderr.
class urdf_errors : public console_bridge::OutputHandler {
 public:
  urdf_errors() : before_(console_bridge::getOutputHandler()) { console_bridge::useOutputHandler(this); }
  ~urdf_errors() override { console_bridge::useOutputHandler(before_); }
  urdf_errors(const urdf_errors&) = delete;
  urdf_errors& operator=(const urdf_errors&) = delete;

  /// All errors, the first one from the inmost element.
  const std::string& text() const { return text_; }
  /// Those of an inertial element, without which urdfdom nevertheless returns a robot.
  const std::string& inertial() const { return inertial_; }

 private:
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level != console_bridge::CONSOLE_BRIDGE_LOG_ERROR) return;
    add(text_, text);
    if (text.find("nertia") != text.npos) add(inertial_, text);
  }
  static void add(std::string& to, const std::string& text) {
    constexpr std::size_t max_size = 300;  // characters of a message
    if (to.size() < max_size)
      to.append(to.empty() ? "" : "; ").append(text).resize(std::min(to.size(), max_size));
  }

  console_bridge::OutputHandler* before_;
  std::string text_, inertial_;
};

/// The text without comments: a URDF that xacro wrote may mention macros there.
inline std::string without_comments(std::string_view xml) {
  std::string text;
  for (std::size_t at = 0; at < xml.size();) {
    const std::size_t begin = std::min(xml.find("<!--", at), xml.size());
    text.append(xml.substr(at, begin - at));
    const std::size_t end = xml.find("-->", begin);
    at = end == xml.npos ? xml.size() : end + 3;
  }
  return text;
}

/// The levels of nesting; urdfdom's parser calls itself for each.
inline int max_depth(std::string_view xml) {
  int depth = 0, max = 0;
  for (std::size_t i = 0; i + 1 < xml.size(); ++i) {
    const std::string_view two = xml.substr(i, 2);
    if (two == "</" || two == "/>") --depth;
    else if (two[0] == '<' && two[1] != '!' && two[1] != '?') max = std::max(max, ++depth);
  }
  return max;
}

inline urdf::ModelInterfaceSharedPtr parse_urdf(const std::filesystem::path& file) {
  constexpr std::uintmax_t max_size = 64 << 20;  // bytes; robots have less than one million
  constexpr int max_nesting = 200;               // a URDF has 6 levels, plugins of a simulator a few more
  const std::string name = "URDF " + file.string();
  std::string xml;
  if (const std::string error = read_file(file, xml, max_size); !error.empty()) fail_urdf(name, error);
  const std::string text = without_comments(xml);
  if (text.find("<xacro:") != text.npos || text.find("${") != text.npos)
    fail_urdf(name, "contains macros of xacro: expected a URDF; run `xacro FILE > robot.urdf` first");
  if (const int depth = max_depth(text); depth > max_nesting)
    fail_urdf(name, error_text("nested elements", depth, "at most " + std::to_string(max_nesting)));
  urdf_errors errors;
  std::string thrown;
  try {
    const auto model = urdf::parseURDF(xml);
    if (model && errors.inertial().empty()) return model;
    if (model) thrown = errors.inertial();
  } catch (const std::exception& error) {
    thrown = error.what();
  }
  fail_urdf(name, "not a URDF: " + (thrown.empty() ? errors.text() : thrown));
}

/// Each link has one parent at most, and the ancestors of `tip` end at a root.
inline void require_tree(const urdf::ModelInterface& model, const std::string& name,
                         urdf::LinkConstSharedPtr tip) {
  std::map<std::string, std::string> joint_of;  // by child
  for (const auto& [joint_name, joint] : model.joints_) {
    const auto [found, is_new] = joint_of.emplace(joint->child_link_name, joint_name);
    if (!is_new)
      fail_urdf(name, "link '" + found->first + "' is the child of joints '" + found->second + "' and '" +
                          joint_name + "': expected one parent: closed loops are no serial chain");
  }
  const std::string last = tip->name;
  for (std::size_t i = 0; i <= model.links_.size(); ++i, tip = tip->getParent())
    if (!tip) return;
  fail_urdf(name, "the joints before link '" + last + "' form a loop: expected a tree of links");
}

inline urdf::LinkConstSharedPtr urdf_link(const urdf::ModelInterface& model, const std::string& name,
                                          const char* argument, const std::string& link) {
  if (auto found = model.getLink(link)) return found;
  constexpr std::size_t max_size = 400;  // characters of a message
  std::string names;
  for (const auto& one : model.links_)
    names.append(names.empty() ? "'" : ", '").append(one.first).append("'");
  if (names.size() > max_size) names.replace(max_size, names.npos, "...");
  fail_urdf(name, std::string(argument) + " = '" + link + "': expected one of its links: " + names);
}

/// The links from behind `base` to `tip`.
inline std::vector<urdf::LinkConstSharedPtr> urdf_path(const urdf::ModelInterface& model,
                                                       const std::string& name, const std::string& base,
                                                       const std::string& tip) {
  const auto from = urdf_link(model, name, "base_link", base);
  const auto to = urdf_link(model, name, "tip_link", tip);
  require_tree(model, name, to);
  std::vector<urdf::LinkConstSharedPtr> links;
  std::string before;
  for (urdf::LinkConstSharedPtr link = to; link; link = link->getParent()) {
    if (link == from) {
      std::reverse(links.begin(), links.end());
      return links;
    }
    if (link != to) before.append(before.empty() ? "'" : ", '").append(link->name).append("'");
    links.push_back(link);
  }
  fail_urdf(name, "base_link = '" + base + "': expected a link before tip_link = '" + tip +
                      "': " + (before.empty() ? "it has none" : before));
}

inline vector<double, 3> vector_of(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

inline Eigen::Isometry3d frame_of(const urdf::Pose& pose) {
  double x = 0, y = 0, z = 0, w = 1;
  pose.rotation.getQuaternion(x, y, z, w);
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.linear() = Eigen::Quaterniond(w, x, y, z).toRotationMatrix();
  frame.translation() = vector_of(pose.position);
  return frame;
}

inline joint_kind urdf_joint_kind(const urdf::Joint& joint, const std::string& name) {
  const std::string about = "joint '" + joint.name + "': ";
  if (joint.mimic)
    fail_urdf(name, about + "mimics joint '" + joint.mimic->joint_name +
                        "': expected a joint that moves by itself; end the chain before it or make it fixed");
  if (joint.type == urdf::Joint::PRISMATIC) return joint_kind::prismatic;
  if (joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS)
    return joint_kind::revolute;
  fail_urdf(name, about + "type = " + (joint.type == urdf::Joint::FLOATING ? "floating" : "planar") +
                      ": expected revolute, continuous, prismatic or fixed");
}

/// About the centre of mass, in the axes of the inertial element.
inline matrix<double, 3, 3> urdf_moments(const urdf::Link& link, urdf_chain& to, urdf_inertia choice) {
  const urdf::Inertial& i = *link.inertial;
  matrix<double, 3, 3> about;
  about << i.ixx, i.ixy, i.ixz, i.ixy, i.iyy, i.iyz, i.ixz, i.iyz, i.izz;
  const std::string at = "link '" + link.name + "': ";
  if (!range::not_negative.contains(i.mass))
    fail_urdf(to.name, at + error_text("mass [kg]", i.mass, to_text(range::not_negative)));
  if (!about.allFinite() || !vector_of(i.origin.position).allFinite())
    fail_urdf(to.name, at + "its inertial element is not finite: expected finite numbers");
  if (check_inertia<double>("", about).empty()) return about;
  // int r r^T dm: its principal values are half the excess of two principal moments over the third
  const matrix<double, 3, 3> unit = matrix<double, 3, 3>::Identity();
  const Eigen::SelfAdjointEigenSolver<matrix<double, 3, 3>> principal(about.trace() / 2 * unit - about);
  const vector<double, 3> excess = principal.eigenvalues(),
                          moments = vector<double, 3>::Constant(about.trace() / 2) - excess;
  std::string found = at + "principal moments [kg m^2] = " + number_text(moments[0]) + ", " +
                      number_text(moments[1]) + ", " + number_text(moments[2]) + ": ";
  const bool can_be_balanced = moments.minCoeff() >= 0;
  if (can_be_balanced)
    found.append("the largest exceeds the sum of the others by ")
        .append(number_text(std::round(-2000 * excess[0] / (moments[1] + moments[2])) / 10))
        .append(" %, ");
  if (choice == urdf_inertia::as_given || !can_be_balanced)
    fail_urdf(to.name, found + "expected the inertia of a rigid body; correct the file" +
                           (can_be_balanced ? " or take urdf_inertia::balanced" : ""));
  to.remarks.append(found).append("balanced\n");
  const matrix<double, 3, 3> possible =
      principal.eigenvectors() * excess.cwiseMax(0).asDiagonal() * principal.eigenvectors().transpose();
  return possible.trace() * unit - possible;
}

/// Adds a link of the chain and all that is fixed to it, up to the link `next` of the chain, to the body that
/// moves with the last joint.
inline void add_urdf_body(urdf_chain& to, const urdf::LinkConstSharedPtr& link, const Eigen::Isometry3d& at,
                          const urdf::LinkConstSharedPtr& next, urdf_inertia choice) {
  link_inertia<double, 3>& all = to.joints.back().link;
  std::vector<std::pair<urdf::LinkConstSharedPtr, Eigen::Isometry3d>> open{{link, at}};
  while (!open.empty()) {
    const auto [body, frame] = open.back();
    open.pop_back();
    if (body->inertial) {
      const Eigen::Isometry3d own = frame * frame_of(body->inertial->origin);
      const matrix<double, 3, 3> turned =
          own.linear() * urdf_moments(*body, to, choice) * own.linear().transpose();
      const link_inertia<double, 3> one{body->inertial->mass, own.translation(),
                                        (turned + turned.transpose()) / 2};
      if (all.mass + one.mass > 0) all = joined<double, 3>(all, one);
      else all.about_centre += one.about_centre;
    }
    for (const auto& child : body->child_links) {
      const urdf::Joint& joint = *child->parent_joint;
      if (joint.type == urdf::Joint::FIXED)
        open.emplace_back(child, frame * frame_of(joint.parent_to_joint_origin_transform));
      else if (child != next)
        to.remarks += "joint '" + joint.name + "' is next to the chain: link '" + child->name +
                      "' and all after it are left out\n";
    }
  }
}

inline void add_urdf_joint(urdf_chain& to, const urdf::Joint& joint, const Eigen::Isometry3d& frame) {
  const joint_kind kind = urdf_joint_kind(joint, to.name);
  const vector<double, 3> axis = vector_of(joint.axis);
  if (!range::direction.contains(axis.norm()))
    fail_urdf(to.name, "joint '" + joint.name +
                           "': " + error_text("length of its axis", axis.norm(), to_text(range::direction)));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  urdf_joint made{joint.name, {kind, frame.linear() * axis, frame.translation()}, {}, -infinity, infinity, 0,
                  0};
  if (joint.limits) {
    if (joint.type != urdf::Joint::CONTINUOUS)
      made.lower = joint.limits->lower, made.upper = joint.limits->upper;
    made.velocity = joint.limits->velocity;
    made.effort = joint.limits->effort;
  }
  to.joints.push_back(std::move(made));
}

}  // namespace detail

/// The chain from `base_link` to `tip_link`, from the base outwards. Links behind fixed joints are part of
/// the link before, also those next to the chain, such as a camera. Meshes are not read. For set-up, by one
/// thread: urdfdom reports errors through a global variable.
///
/// Throws std::invalid_argument, its text names the file and the element: no regular file, no URDF, macros of
/// xacro; no such link, links that are no tree; joints that are floating, planar or mimic another one, an
/// axis of zero; a negative mass, an inertia that no rigid body has, a moving joint without mass before the
/// next one.
inline urdf_chain read_urdf(const std::filesystem::path& file, const std::string& base_link,
                            const std::string& tip_link, const urdf_options& options = {}) {
  const urdf::ModelInterfaceSharedPtr model = detail::parse_urdf(file);
  urdf_chain chain;
  chain.name = "URDF " + file.string();
  chain.gravity = options.gravity;
  const auto links = detail::urdf_path(*model, chain.name, base_link, tip_link);
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  for (std::size_t i = 0; i < links.size(); ++i) {
    const urdf::Joint& joint = *links[i]->parent_joint;
    frame = frame * detail::frame_of(joint.parent_to_joint_origin_transform);
    if (!frame.matrix().allFinite())
      detail::fail_urdf(chain.name,
                        "joint '" + joint.name + "': its origin is not finite: expected finite numbers");
    if (joint.type == urdf::Joint::FIXED) continue;  // part of the body before
    detail::add_urdf_joint(chain, joint, frame);
    const auto next = std::find_if(links.begin() + std::ptrdiff_t(i) + 1, links.end(), [](const auto& one) {
      return one->parent_joint->type != urdf::Joint::FIXED;
    });
    detail::add_urdf_body(chain, links[i], frame, next == links.end() ? nullptr : *next, options.inertia);
  }
  for (const urdf_joint& one : chain.joints)
    if (!(one.link.mass > 0))
      detail::fail_urdf(chain.name,
                        "joint '" + one.name +
                            "': no mass moves with it before the next joint: expected a mass > 0; "
                            "give its child link an inertial element");
  chain.handle = frame * options.tool;
  return chain;
}

/// The plane that a chain moves in.
struct urdf_plane {
  matrix<double, 2, 3> axes = matrix<double, 2, 3>::Zero();  ///< x and y as rows, frame of the base link.
  std::string error;                                         ///< Why there is no such plane; else empty.
};

/// The plane that a chain moves in. x is the base link's x axis in that plane (its y axis if x is the
/// normal), and the first revolute joint turns from x to y. All joints keep to the plane within 0.001 rad.
inline urdf_plane plane_of(const urdf_chain& chain) {
  constexpr double tolerance = 1e-3;  // [rad]; files round pi/2 to 1.57
  urdf_plane plane;
  const auto turns = [](const urdf_joint& one) { return one.joint.kind == joint_kind::revolute; };
  const auto first = std::find_if(chain.joints.begin(), chain.joints.end(), turns);
  vector<double, 3> normal = vector<double, 3>::Zero();
  if (first != chain.joints.end()) normal = first->joint.axis.normalized();
  else if (chain.joints.size() > 1)
    normal = cross(chain.joints[0].joint.axis, chain.joints[1].joint.axis).normalized();
  if (normal.isZero())
    plane.error = "its joints slide along one line: expected a chain that moves in a plane";
  for (const urdf_joint& one : chain.joints) {
    const vector<double, 3> axis = one.joint.axis.normalized();
    const double along = axis.dot(normal), off = turns(one) ? (axis - normal).norm() : std::abs(along);
    if (off <= tolerance || !plane.error.empty()) continue;
    plane.error = "joint '" + one.name + "': its axis ";
    if (turns(one) && (axis + normal).norm() <= tolerance)
      plane.error +=
          "is opposite to that of joint '" + first->name +
          "': expected the same direction; turn it in the file, which changes the sign of its position";
    else
      plane.error +=
          "leaves the plane of the joints before: expected a chain that moves in one plane; take three "
          "dimensions";
  }
  if (!plane.error.empty()) return plane;
  vector<double, 3> x = vector<double, 3>::UnitX();
  if (cross(x, normal).norm() < tolerance) x = vector<double, 3>::UnitY();
  x = (x - x.dot(normal) * normal).normalized();
  plane.axes << x.transpose(), cross(normal, x).transpose();
  return plane;
}

/// The chain with N joints as a mechanism; with D = 2 in the plane of plane_of. Rotors and the handle have no
/// inertia of their own. Throws std::invalid_argument if the chain has
/// another number of joints, which the text states, or D = 2 and it does not move in a plane.
template <int N, int D = 3>
serial_chain_with_inertia<double, N, D> chain_of(const urdf_chain& chain) {
  if (std::ssize(chain.joints) != N) {
    std::string names;
    for (const urdf_joint& one : chain.joints) names.append(names.empty() ? "" : ", ").append(one.name);
    detail::fail_urdf(chain.name, "moving joints = " + std::to_string(chain.joints.size()) + " (" + names +
                                      "): expected " + std::to_string(N) + "; write chain_from_urdf<" +
                                      std::to_string(chain.joints.size()) + "> or choose other links");
  }
  matrix<double, D, 3> to;  // from the base link's axes
  matrix<double, 3, angular_size<D>> about;
  if constexpr (D == 3) {
    to.setIdentity();
    about.setIdentity();
  } else {
    const urdf_plane plane = plane_of(chain);
    if (!plane.error.empty()) detail::fail_urdf(chain.name, plane.error);
    to = plane.axes;
    about = cross(vector<double, 3>(to.row(0)), vector<double, 3>(to.row(1)));
  }
  serial_chain_parameters<double, N, D> geometry;
  serial_chain_inertia<double, N, D> inertia;
  for (std::size_t i = 0; i < std::size_t(N); ++i) {
    const urdf_joint& one = chain.joints[i];
    geometry.joints[i] = {one.joint.kind, to * one.joint.axis, to * one.joint.point};
    inertia.links[i] = {one.link.mass, to * one.link.centre,
                        about.transpose() * one.link.about_centre * about};
  }
  geometry.handle = to * chain.handle;
  inertia.rotor_inertia.setZero();
  inertia.handle_mass = 0;
  inertia.gravity = to * chain.gravity;
  return {geometry, inertia};
}

/// read_urdf, then chain_of.
template <int N, int D = 3>
serial_chain_with_inertia<double, N, D> chain_from_urdf(const std::filesystem::path& file,
                                                        const std::string& base_link,
                                                        const std::string& tip_link,
                                                        const urdf_options& options = {}) {
  return chain_of<N, D>(read_urdf(file, base_link, tip_link, options));
}

}  // namespace passive_haptics
