// Pinocchio: the frame's placement and Jacobian in one pass over the chain. Gives the orientation as well.
#include "../kinematics_problems.hpp"

#include <pinocchio/algorithm/frames.hpp>

namespace {

using namespace peers;
namespace pin = pinocchio;

class pinocchio_frame {
 public:
  void solve(const arm_pose& q) {
    pin::computeFrameJacobian(model_, data_, q, handle_, pin::LOCAL_WORLD_ALIGNED, jacobian_);
  }
  ph::vector<double, 3> handle() const { return data_.oMf[handle_].translation(); }
  ph::matrix<double, 3, 6> jacobian() const { return jacobian_.topRows<3>(); }

 private:
  static pin::Model model() {
    pin::Model arm;
    pin::JointIndex parent = 0;
    pin::SE3 placement = pin::SE3::Identity();  // of the next joint in its parent
    for (const auto& row : arm_table()) {
      parent = arm.addJoint(parent, pin::JointModelRZ(), placement, "joint " + std::to_string(parent + 1));
      placement = pin::SE3(Eigen::AngleAxisd(row.twist, Eigen::Vector3d::UnitX()).toRotationMatrix(),
                           Eigen::Vector3d(row.length, 0, row.offset));
    }
    arm.addFrame(pin::Frame("handle", parent, placement, pin::OP_FRAME));
    return arm;
  }

  const pin::Model model_ = model();
  pin::Data data_{model_};
  const pin::FrameIndex handle_ = model_.getFrameId("handle");
  pin::Data::Matrix6x jacobian_ = pin::Data::Matrix6x::Zero(6, 6);
};

const bool added = add_kinematics_solver<pinocchio_frame>(PEER);

}  // namespace
