// KDL: the position solver and the Jacobian solver of a chain, kept from pose to pose. Gives the orientation
// as well.
#include "../kinematics_problems.hpp"

#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>

namespace {

using namespace peers;

KDL::Chain chain() {
  KDL::Chain arm;
  for (const auto& row : arm_table())
    arm.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::RotZ),
                                KDL::Frame::DH(row.length, row.twist, row.offset, row.angle)));
  return arm;
}

class kdl {
 public:
  void solve(const arm_pose& q) {
    q_.data = q;
    position_solver_.JntToCart(q_, frame_);
    jacobian_solver_.JntToJac(q_, jacobian_);
  }
  ph::vector<double, 3> handle() const { return {frame_.p.x(), frame_.p.y(), frame_.p.z()}; }
  ph::matrix<double, 3, 6> jacobian() const { return jacobian_.data.topRows<3>(); }

 private:
  const KDL::Chain chain_ = chain();
  KDL::ChainFkSolverPos_recursive position_solver_{chain_};
  KDL::ChainJntToJacSolver jacobian_solver_{chain_};
  KDL::JntArray q_{6};
  KDL::Frame frame_;
  KDL::Jacobian jacobian_{6};
};

const bool added = add_kinematics_solver<kdl>(PEER);

}  // namespace
