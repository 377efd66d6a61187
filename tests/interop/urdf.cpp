// Chains of URDF files: real robots against KDL, which files and links are rejected, and with which message.
#include <passive_haptics/interop/urdf.hpp>
#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include "../../docs/guide/chain_from_kdl.hpp"
#include "../unit/files/mesh_files.hpp"

#include <kdl/chaindynparam.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>

namespace {

namespace fs = std::filesystem;
using mesh_files::in_a_folder, mesh_files::replaced;

const fs::path robots = fs::path(PASSIVE_HAPTICS_SOURCE_DIR) / "tests/interop/robots";

// ---- real robots against KDL ----------------------------------------------------------------------

KDL::Vector in_kdl(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

KDL::Frame in_kdl(const urdf::Pose& p) {
  double x, y, z, w;
  p.rotation.getQuaternion(x, y, z, w);
  return {KDL::Rotation::Quaternion(x, y, z, w), in_kdl(p.position)};
}

KDL::Chain kdl_chain(const fs::path& file, const std::string& base, const std::string& tip) {
  const auto model = urdf::parseURDFFile(file.string());
  std::vector<urdf::LinkConstSharedPtr> links;
  for (urdf::LinkConstSharedPtr l = model->getLink(tip); l->name != base; l = l->getParent())
    links.insert(links.begin(), l);
  KDL::Chain chain;
  for (const auto& l : links) {
    const urdf::Joint& j = *l->parent_joint;
    const KDL::Frame to = in_kdl(j.parent_to_joint_origin_transform);
    const auto type = j.type == urdf::Joint::PRISMATIC ? KDL::Joint::TransAxis : KDL::Joint::RotAxis;
    const KDL::Joint joint = j.type == urdf::Joint::FIXED
                                 ? KDL::Joint(j.name, KDL::Joint::None)
                                 : KDL::Joint(j.name, to.p, to.M * in_kdl(j.axis), type);
    KDL::RigidBodyInertia inertia = KDL::RigidBodyInertia::Zero();
    if (l->inertial) {
      const urdf::Inertial& i = *l->inertial;
      const KDL::RotationalInertia about(i.ixx, i.iyy, i.izz, i.ixy, i.ixz, i.iyz);
      inertia = in_kdl(i.origin) * KDL::RigidBodyInertia(i.mass, KDL::Vector::Zero(), about);
    }
    chain.addSegment(KDL::Segment(l->name, joint, to, inertia));
  }
  return chain;
}

// KDL's position, J, M, Coriolis torque and gravity torque.
struct kdl_solution {
  Eigen::Vector3d x;
  Eigen::MatrixXd J, M, c, g;

  kdl_solution(const KDL::Chain& chain, const Eigen::VectorXd& at, const Eigen::VectorXd& rates,
               const KDL::Vector& gravity) {
    const unsigned n = chain.getNrOfJoints();
    KDL::JntArray q(n), qd(n), coriolis(n), weight(n);
    q.data = at, qd.data = rates;
    KDL::Frame frame;
    KDL::ChainFkSolverPos_recursive(chain).JntToCart(q, frame);
    KDL::Jacobian jacobian(n);
    KDL::ChainJntToJacSolver(chain).JntToJac(q, jacobian);
    KDL::JntSpaceInertiaMatrix mass(static_cast<int>(n));
    KDL::ChainDynParam dynamics(chain, gravity);
    dynamics.JntToMass(q, mass), dynamics.JntToCoriolis(q, qd, coriolis), dynamics.JntToGravity(q, weight);
    x = in_eigen(frame.p);
    J = jacobian.data.topRows<3>();
    M = mass.data, c = coriolis.data, g = weight.data;
  }
};

struct differences {
  double position = 0, J = 0, M = 0, torque = 0;  // relative to the largest of all poses

  template <int N, int D>
  static differences between(const ph::serial_chain_with_inertia<double, N, D>& ours, const KDL::Chain& chain,
                             const Eigen::Matrix<double, D, 3>& axes) {
    const KDL::Vector gravity(1, -2, -9);
    ph::testing::random_source random(20040627);
    differences worst, size;
    const auto add = [](double& difference, double& scale, const auto& a, const auto& b) {
      difference = std::max(difference, (a - b).norm());
      scale = std::max(scale, b.norm());
    };
    for (int i = 0; i < 200; ++i) {
      const ph::vector<double, N> q = 2 * random.normal_vector<double, N>(),
                                  qd = random.normal_vector<double, N>();
      const kdl_solution kdl(chain, q, qd, gravity);
      add(worst.position, size.position, ours.position(q), axes * kdl.x);
      add(worst.J, size.J, ours.jacobian(q), axes * kdl.J);
      add(worst.M, size.M, ours.mass_matrix(q), kdl.M);
      add(worst.torque, size.torque, ours.bias_torque(q, qd), kdl.c + kdl.g);
    }
    return {worst.position / size.position, worst.J / size.J, worst.M / size.M, worst.torque / size.torque};
  }
};

template <int N, int D = 3>
void expect_as_kdl(const char* file, const char* base, const char* tip,
                   const Eigen::Matrix<double, D, 3>& axes = Eigen::Matrix<double, D, 3>::Identity()) {
  const auto ours = ph::chain_from_urdf<N, D>(robots / file, base, tip, {.gravity = {1, -2, -9}});
  const KDL::Chain chain = kdl_chain(robots / file, base, tip);
  const differences d = differences::between<N, D>(ours, chain, axes);
  std::printf("%s, %d joints: position %.1e, J %.1e, M %.1e, torque %.1e\n", file, N, d.position, d.J, d.M,
              d.torque);
  EXPECT_LT(d.position, 1e-14) << file;
  EXPECT_LT(d.J, 1e-13) << file;
  EXPECT_LT(d.M, 1e-12) << file;
  EXPECT_LT(d.torque, 1e-12) << file;
  if constexpr (D == 3) {
    const auto converted = chain_from_kdl<N>(chain);
    const ph::vector<double, N> q = ph::vector<double, N>::LinSpaced(N, -1, 2);
    EXPECT_LT((converted.position(q) - ours.position(q)).norm(), 1e-14);
    EXPECT_LT((converted.mass_matrix(q) - ours.mass_matrix(q)).norm(), 1e-12 * ours.mass_matrix(q).norm());
  }
}

TEST(a_robot_of_a_urdf, has_the_position_jacobian_and_inertia_of_kdl) {
  expect_as_kdl<3>("anymal_leg.urdf", "base", "LF_FOOT");
  expect_as_kdl<3>("finger_edu.urdf", "base_link", "finger_tip_link");
  expect_as_kdl<6>("ur5.urdf", "world", "tool0");
  expect_as_kdl<6>("kinova.urdf", "j2s6s200_link_base", "j2s6s200_end_effector");
  expect_as_kdl<7>("baxter.urdf", "torso", "left_gripper");
  expect_as_kdl<7>("pr2.urdf", "torso_lift_link", "r_gripper_tool_frame");
  expect_as_kdl<8>("pr2.urdf", "base_link", "r_gripper_tool_frame");  // its first joint slides
  expect_as_kdl<2, 2>("two_dofs.urdf", "ground", "Tip", ph::matrix<double, 2, 3>{{1, 0, 0}, {0, 1, 0}});
  expect_as_kdl<2, 2>("double_pendulum.urdf", "base_link", "link2",
                      ph::matrix<double, 2, 3>{{0, 1, 0}, {0, 0, 1}});
}

// Its handle 1 mm in a floor and moving deeper.
template <int N>
void expect_controlled(const char* file, const char* base, const char* tip) {
  const auto arm = ph::chain_from_urdf<N>(robots / file, base, tip);
  using device = ph::serial_chain_with_inertia<double, N, 3>;
  ph::device_state<device> state;
  state.time = 0;
  state.q.setConstant(0.5);
  state.qd = -arm.jacobian(state.q).row(2).transpose();
  state.hand_force = {0, 0, -1};
  const ph::half_space<3> floor(arm.position(state.q) + ph::point<3>(0, 0, 1e-3), {0, 0, 1});
  ph::controller control(arm, ph::brakes_of<device>(), ph::scene(ph::wall(floor)), ph::direct_control());
  const auto result = control(state);
  EXPECT_EQ(result.outcome, ph::status::ok) << file;
  EXPECT_GT(result.capacity.maxCoeff(), 0) << file;
}

TEST(a_robot_of_a_urdf, has_a_controller) {
  expect_controlled<3>("anymal_leg.urdf", "base", "LF_FOOT");
  expect_controlled<7>("baxter.urdf", "torso", "left_gripper");
}

// ---- a small arm: a table, a column that slides, two links, a camera and a gripper -------------------

const std::string arm = R"(<?xml version="1.0"?>
<robot name="arm">
  <link name="table"/>
  <joint name="lift" type="prismatic">
    <parent link="table"/><child link="column"/><origin xyz="0 0 0.5"/><axis xyz="0 0 1"/>
    <limit lower="0" upper="0.3" effort="1000" velocity="0.1"/>
  </joint>
  <link name="column">
    <inertial><mass value="2"/><inertia ixx="0.02" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.01"/></inertial>
  </link>
  <joint name="shoulder" type="continuous">
    <parent link="column"/><child link="upper"/><axis xyz="0 0 2"/>
  </joint>
  <link name="upper">
    <inertial><origin xyz="0.1 0 0"/><mass value="1"/>
      <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.004" iyz="0" izz="0.004"/></inertial>
    <visual><geometry><mesh filename="package://none/upper.dae"/></geometry></visual>
    <collision><geometry><mesh filename="http://127.0.0.1/upper.stl"/></geometry></collision>
  </link>
  <joint name="mount" type="fixed">
    <parent link="upper"/><child link="camera"/><origin xyz="0.1 0 0.1"/>
  </joint>
  <link name="camera">
    <inertial><mass value="0.2"/><inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial>
  </link>
  <joint name="elbow" type="revolute">
    <parent link="upper"/><child link="forearm"/><origin xyz="0.2 0 0" rpy="0 0 1.5707963267948966"/>
    <axis xyz="0 0 1"/>
    <limit lower="-2" upper="2" effort="0" velocity="1"/>
  </joint>
  <link name="forearm">
    <inertial><origin xyz="0.05 0 0" rpy="0 0 0.5"/><mass value="0.5"/>
      <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.002" iyz="0" izz="0.002"/></inertial>
  </link>
  <joint name="flange" type="fixed">
    <parent link="forearm"/><child link="tool"/><origin xyz="0.1 0 0"/>
  </joint>
  <link name="tool"/>
  <joint name="finger" type="prismatic">
    <parent link="tool"/><child link="jaw"/><axis xyz="0 1 0"/>
    <limit lower="0" upper="0.1" effort="1" velocity="1"/>
  </joint>
  <link name="jaw"/>
</robot>
)";

struct a_urdf : in_a_folder {
  ph::urdf_chain read(const std::string& text, const ph::urdf_options& options = {}) const {
    return ph::read_urdf(write("arm.urdf", text), "table", "tool", options);
  }
  // What a call throws, behind "passive_haptics: URDF PATH: ".
  template <class Call>
  std::string error_text(Call call) const {
    const std::string start = "passive_haptics: URDF " + (folder / "arm.urdf").string() + ": ";
    try {
      call();
    } catch (const std::invalid_argument& error) {
      const std::string text = error.what();
      return text.starts_with(start) ? text.substr(start.size()) : "not so named: " + text;
    }
    return "none";
  }
};

TEST_F(a_urdf, reports_joints_limits_and_what_is_next_to_the_chain) {
  const ph::urdf_chain chain = read(arm);
  ASSERT_EQ(chain.joints.size(), 3u);
  EXPECT_EQ(chain.joints[0].name, "lift");
  EXPECT_EQ(chain.joints[0].joint.kind, ph::joint_kind::prismatic);
  EXPECT_EQ(chain.joints[0].effort, 1000);
  EXPECT_EQ(chain.joints[0].upper, 0.3);
  EXPECT_TRUE(std::isinf(chain.joints[1].lower) && std::isinf(chain.joints[1].upper)) << "continuous";
  EXPECT_EQ(chain.joints[2].effort, 0);
  EXPECT_EQ(chain.joints[1].link.mass, 1.2) << "with the camera";
  EXPECT_EQ(chain.joints[1].link.centre, ph::point<3>(0.1, 0, 0.5 + 0.1 * 0.2 / 1.2));
  EXPECT_EQ(chain.remarks, "joint 'finger' is next to the chain: link 'jaw' and all after it are left out\n");
}

TEST_F(a_urdf, has_its_handle_at_the_tool_and_gravity_in_the_frame_of_the_base) {
  const auto at = [&](const ph::urdf_options& options) { return ph::chain_of<3>(read(arm, options)); };
  const ph::vector<double, 3> q(0.1, 0, 0), still(0, 0, 0);
  EXPECT_LT((at({}).position(q) - ph::point<3>(0.2, 0.1, 0.6)).norm(), 1e-15);
  EXPECT_LT((at({.tool = {0.05, 0, -0.1}}).position(q) - ph::point<3>(0.2, 0.15, 0.5)).norm(), 1e-15)
      << "turned with the forearm";
  EXPECT_NEAR(at({.gravity = {0, 0, -10}}).bias_torque(q, still)[0], 10 * (2 + 1.2 + 0.5), 1e-12);
  EXPECT_EQ(at({}).bias_torque(q, still), still);
}

TEST_F(a_urdf, with_parallel_joints_is_planar_in_its_own_plane) {
  const fs::path path = write("arm.urdf", arm);
  const auto planar = ph::chain_from_urdf<2, 2>(path, "column", "tool");
  EXPECT_LT((planar.position({0, 0}) - ph::point<2>(0.2, 0.1)).norm(), 1e-15);
  const ph::vector<double, 3> q(0, 0.3, 0.4);
  EXPECT_LT((planar.mass_matrix({0.3, 0.4}) -
             ph::chain_from_urdf<3>(path, "table", "tool").mass_matrix(q).bottomRightCorner<2, 2>())
                .norm(),
            1e-16);
  const auto error = [&](const std::string& axis, const char* base = "column") {
    write("arm.urdf", replaced(arm, R"(<axis xyz="0 0 1"/>
    <limit lower="-2")",
                               "<axis xyz=\"" + axis + "\"/>\n    <limit lower=\"-2\""));
    return error_text([&] { ph::chain_from_urdf<2, 2>(path, base, "tool"); });
  };
  EXPECT_EQ(error("0 0.0008 1"), "none") << "1.57 for pi/2";
  EXPECT_EQ(error("0 0 -1"),
            "joint 'elbow': its axis is opposite to that of joint 'shoulder': expected the same direction; "
            "turn it in the "
            "file, which changes the sign of its position");
  EXPECT_EQ(error("0 1 0"),
            "joint 'elbow': its axis leaves the plane of the joints before: expected a chain that moves in "
            "one plane; take "
            "three dimensions");
}

TEST_F(a_urdf, of_an_inertia_that_no_body_has_is_balanced_if_that_is_chosen) {
  const std::string text =
      replaced(arm, R"(iyy="0.02" iyz="0" izz="0.01")", R"(iyy="0.03" iyz="0" izz="0.051")");
  const std::string found =
      "link 'column': principal moments [kg m^2] = 0.051, 0.03, 0.02: the largest exceeds the sum of the "
      "others by 2 %, ";
  EXPECT_EQ(error_text([&] { read(text); }),
            found + "expected the inertia of a rigid body; correct the file or take urdf_inertia::balanced");
  const auto chain = read(text, {.inertia = ph::urdf_inertia::balanced});
  EXPECT_TRUE(chain.remarks.starts_with(found + "balanced\n")) << chain.remarks;
  EXPECT_LT((chain.joints[0].link.about_centre.diagonal() - ph::point<3>(0.0205, 0.0305, 0.051)).norm(),
            1e-16);
  ph::chain_of<3>(chain);
  EXPECT_TRUE(error_text([&] {
                read(replaced(arm, R"(izz="0.01")", R"(izz="-1")"), {.inertia = ph::urdf_inertia::balanced});
              }).ends_with("expected the inertia of a rigid body; correct the file"));
}

// A change of the arm, and the line that reports it.
struct wrong_urdf {
  const char *what, *by, *error;
};
constexpr const char *elbow = R"(<joint name="elbow" type="revolute">)", *axis = R"(<axis xyz="0 0 2"/>)",
                     *mass = R"(<mass value="2"/>)", *inertia = R"(ixx="0.02" ixy="0")",
                     *tool = R"(<link name="tool"/>)", *last = "</robot>";
const wrong_urdf wrong_urdfs[] = {
    {R"(<robot name="arm">)", R"(<robot name="arm"><xacro:include filename="a.xacro"/>)",
     "contains macros of xacro: expected a URDF; run `xacro FILE > robot.urdf` first"},
    {mass, R"(<mass value="${mass}"/>)",
     "contains macros of xacro: expected a URDF; run `xacro FILE > robot.urdf` first"},
    {elbow, R"(<joint name="elbow" type="floating">)",
     "joint 'elbow': type = floating: expected revolute, continuous, prismatic or fixed"},
    {elbow, R"(<joint name="elbow" type="planar">)",
     "joint 'elbow': type = planar: expected revolute, continuous, prismatic or fixed"},
    {elbow, R"(<joint name="elbow" type="revolute"><mimic joint="shoulder"/>)",
     "joint 'elbow': mimics joint 'shoulder': expected a joint that moves by itself; end the chain before it "
     "or make it fixed"},
    {axis, R"(<axis xyz="0 0 0"/>)", "joint 'shoulder': length of its axis = 0: expected a direction"},
    {mass, R"(<mass value="-2"/>)", "link 'column': mass [kg] = -2: expected a finite number >= 0"},
    {mass, R"(<mass value="0"/>)",
     "joint 'lift': no mass moves with it before the next joint: expected a mass > 0; give its child link an "
     "inertial element"},
    {inertia, R"(ixx="0.02" ixy="0.1")",
     "link 'column': principal moments [kg m^2] = 0.12, 0.01, -0.08: expected the inertia of a rigid body; "
     "correct the file"},
    {last, R"(<joint name="loop" type="fixed"><parent link="tool"/><child link="upper"/></joint></robot>)",
     "link 'upper' is the child of joints 'loop' and 'shoulder': expected one parent: closed loops are no "
     "serial chain"},
    {R"(<parent link="forearm"/><child link="tool"/>)", R"(<parent link="tool"/><child link="tool"/>)",
     "the joints before link 'tool' form a loop: expected a tree of links"},
};
// Likewise, reported by urdfdom: the element that it names.
const wrong_urdf not_urdfs[] = {
    {elbow, R"(<joint name="elbow" type="screw">)", "elbow"},
    {elbow, R"(<joint name="elbow">)", "elbow"},
    {axis, R"(<axis xyz="0 0"/>)", "shoulder"},
    {axis, R"(<axis xyz="0 0 nan"/>)", "shoulder"},
    {R"(<limit lower="-2" upper="2" effort="0" velocity="1"/>)", "", "elbow"},
    {R"(<limit lower="-2")", R"(<limit lower="two")", "elbow"},
    {R"(rpy="0 0 1.5707963267948966")", R"(rpy="0 0 right")", "elbow"},
    {R"(<link name="column">)", R"(<link name="column"><inertial></inertial>)", "column"},
    {mass, R"(<mass value="heavy"/>)", "column"},
    {mass, R"(<mass value="1e999"/>)", "column"},
    {mass, "", "column"},
    {inertia, R"(ixx="0.02")", "column"},
    {R"(<child link="forearm"/>)", R"(<child link="arm"/>)", "elbow"},
    {R"(<parent link="upper"/><child link="forearm"/>)", R"(<child link="forearm"/>)", "elbow"},
    {tool, R"(<link name="tools"/>)", "tool"},
    {last, R"(<link name="alone"/></robot>)", "alone"},
    {last, R"(<link name="jaw"/></robot>)", "jaw"},
    {R"(<joint name="flange")", R"(<joint name="elbow")", "elbow"},
    {last, "", ""},
};

TEST_F(a_urdf, that_is_wrong_is_reported_in_one_line) {
  const auto error = [&](const wrong_urdf& wrong) {
    const std::string text = replaced(arm, wrong.what, wrong.by);
    EXPECT_NE(text, arm) << wrong.what;
    return error_text([&] { read(text); });
  };
  for (const wrong_urdf& wrong : wrong_urdfs) EXPECT_EQ(error(wrong), wrong.error);
  for (const wrong_urdf& wrong : not_urdfs) {
    const std::string line = error(wrong);
    EXPECT_TRUE(line.starts_with("not a URDF: ") && line.find(wrong.error) != line.npos) << line << "\n"
                                                                                         << wrong.by;
    EXPECT_EQ(line.find('\n'), line.npos) << line;
  }
}

TEST_F(a_urdf, is_asked_for_links_and_joints_that_it_has) {
  const fs::path path = write("arm.urdf", arm);
  const auto error = [&](const char* base, const char* tip) {
    return error_text([&] { ph::chain_from_urdf<7>(path, base, tip); });
  };
  const std::string links = "'camera', 'column', 'forearm', 'jaw', 'table', 'tool', 'upper'";
  EXPECT_EQ(error("table", "tool"),
            "moving joints = 3 (lift, shoulder, elbow): expected 7; write chain_from_urdf<3> or choose other "
            "links");
  EXPECT_EQ(error("table", "tol"), "tip_link = 'tol': expected one of its links: " + links);
  EXPECT_EQ(error("base", "tool"), "base_link = 'base': expected one of its links: " + links);
  EXPECT_EQ(error("tool", "table"),
            "base_link = 'tool': expected a link before tip_link = 'table': it has none");
  EXPECT_EQ(error("camera", "tool"),
            "base_link = 'camera': expected a link before tip_link = 'tool': 'forearm', 'upper', 'column', "
            "'table'");
  EXPECT_EQ(error("tool", "tool"),
            "moving joints = 0 (): expected 7; write chain_from_urdf<0> or choose other links");
}

TEST_F(a_urdf, with_bytes_gone_wrong_is_a_chain_or_is_named) {
  ph::testing::random_source random(20040627);
  int read = 0, rejected = 0;
  for (int k = 0; k < 1000; ++k) {
    std::string text = arm;
    const auto somewhere = [&] { return static_cast<std::size_t>(random.uniform(0.0, double(text.size()))); };
    if (k % 8 == 0) text.resize(somewhere());
    for (int hits = 0; hits < 2 && !text.empty(); ++hits)
      text[somewhere()] = "0123456789 -.<>/\"=e\n"[static_cast<std::size_t>(random.uniform(0.0, 20.0))];
    const std::string error = error_text([&] { ph::chain_of<3>(this->read(text)); });
    EXPECT_FALSE(error.starts_with("not so named")) << error << "\nseed 20040627, file " << k;
    ++(error == "none" ? read : rejected);
  }
  EXPECT_GT(read, 50);
  EXPECT_GT(rejected, 300);
}

TEST_F(a_urdf, is_a_regular_file_that_the_parser_can_take) {
  EXPECT_EQ(error_text([&] { ph::read_urdf(folder / "arm.urdf", "a", "b"); }), "no such file");
  const std::string deep = "<robot name='a'>" + [] {
    std::string s;
    for (int i = 0; i < 100000; ++i) s += "<a>";
    return s;
  }();
  EXPECT_EQ(error_text([&] { read(deep); }), "nested elements = 100001: expected at most 200");
  EXPECT_EQ(error_text([&] { read(""); }), "not a URDF: Error document empty.");
  EXPECT_EQ(error_text([&] { read("<sdf version='1.6'/>"); }),
            "not a URDF: Could not find the 'robot' element in the xml file");
}

}  // namespace
