// ProxQP, an augmented Lagrangian: dense, cold, and set to look at the duality gap, without which it may
// stop anywhere in the cone. Otherwise as it comes: stops at residuals of 1e-5 and a gap of 1e-4.
#include "../cone_problems.hpp"

#include <proxsuite/proxqp/dense/dense.hpp>

namespace {

using namespace peers;
namespace pq = proxsuite::proxqp;

template <int N>
class proxqp {
 public:
  struct problem {
    problem(const cone_problem<N>& p) : C(p.B.transpose()), g(-p.f) {}
    Eigen::MatrixXd C;
    Eigen::VectorXd g;
  };
  static constexpr double tolerance = 0.02;  // distance <= sqrt(2 gap), and a little for the residuals

  proxqp() {
    solver_.settings.initial_guess = pq::InitialGuessStatus::NO_INITIAL_GUESS;
    solver_.settings.check_duality_gap = true;
    solver_.init(Eigen::MatrixXd::Identity(N, N), Eigen::VectorXd::Zero(N), proxsuite::nullopt,
                 proxsuite::nullopt, Eigen::MatrixXd::Identity(N, N), Eigen::VectorXd::Constant(N, -1e20),
                 Eigen::VectorXd::Zero(N));
  }

  ph::vector<double, N> solve(const problem& p) {
    solver_.update(proxsuite::nullopt, p.g, proxsuite::nullopt, proxsuite::nullopt, p.C, proxsuite::nullopt,
                   proxsuite::nullopt);
    solver_.solve();
    return solver_.results.x;
  }

 private:
  pq::dense::QP<double> solver_{N, 0, N, pq::HessianType::Diagonal};
};

const bool added = add_cone_solver<proxqp>(PEER);

}  // namespace
