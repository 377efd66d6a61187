// qpOASES, a parametric active set, with its fastest options ("MPC") and the Hessian declared to be the
// identity.
#include "../cone_problems.hpp"

#include <qpOASES.hpp>

namespace {

using namespace peers;

template <int N>
class qpoases {
 public:
  struct problem {
    problem(const cone_problem<N>& p) : A(p.B), g(-p.f) {}
    ph::matrix<double, N, N> A;  // stored by rows: its rows are the columns of B
    ph::vector<double, N> g;
  };
  static constexpr double tolerance = 1e-6;

  qpoases() {
    qpOASES::Options options;
    options.setToMPC();
    options.printLevel = qpOASES::PL_NONE;
    solver_.setOptions(options);
  }

  ph::vector<double, N> solve(const problem& p) {
    solver_.reset();
    solver_.setHessianType(qpOASES::HST_IDENTITY);
    qpOASES::int_t recalculations = 100;
    solver_.init(nullptr, p.g.data(), p.A.data(), nullptr, nullptr, nullptr, zero_.data(), recalculations);
    ph::vector<double, N> point;
    solver_.getPrimalSolution(point.data());
    return point;
  }

 private:
  const ph::vector<double, N> zero_ = ph::vector<double, N>::Zero();
  qpOASES::QProblem solver_{N, N, qpOASES::HST_IDENTITY};
};

const bool added = add_cone_solver<qpoases>(PEER);

}  // namespace
