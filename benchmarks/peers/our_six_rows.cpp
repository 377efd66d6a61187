// The library with what the peers of kinematics compute, too: the orientation of the last body, and the rows
// of the Jacobian for the angular velocity. No part of a cycle needs them.
#include "kinematics_problems.hpp"

namespace {

using namespace peers;

class six_rows : ph::serial_chain<double, 6, 3> {
 public:
  six_rows() : serial_chain(ph::from_denavit_hartenberg(arm_table())) {}

  void solve(const arm_pose& q) {
    const auto at = bodies(q);
    handle_ = position(at);
    orientation_ = at.turn.back();
    jacobian_.topRows<3>() = serial_chain::jacobian(at);
    for (int i = 0; i < 6; ++i) jacobian_.block<3, 1>(3, i) = at.rotation[std::size_t(i)];
  }
  const ph::vector<double, 3>& handle() const { return handle_; }
  ph::matrix<double, 3, 6> jacobian() const { return jacobian_.topRows<3>(); }

 private:
  ph::vector<double, 3> handle_;
  ph::matrix<double, 3, 3> orientation_;
  ph::matrix<double, 6, 6> jacobian_;
};

const bool added = add_kinematics_solver<six_rows>("ours, with orientation and six rows");

}  // namespace
