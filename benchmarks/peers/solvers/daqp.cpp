// DAQP, a dual active set. As a least-distance problem, which it solves fastest: x = p - f, min |x|, B^T x <=
// -B^T f. To be built with PROFILING=OFF: else it reads a clock twice a problem.
#include "../cone_problems.hpp"

#include <daqp/api.h>
#include <daqp/utils.h>

#include <array>

namespace {

using namespace peers;

template <int N>
class daqp {
 public:
  using problem = cone_problem<N>;
  static constexpr double tolerance = 1e-4;  // it accepts a violation of 1e-6, which a sharp cone enlarges

  daqp() {
    below_.setConstant(-DAQP_INF);
    above_.setZero();
    qp_.n = qp_.m = N;
    qp_.A = identity_.data();
    qp_.blower = below_.data();
    qp_.bupper = above_.data();
    result_.x = x_.data();
    setup_daqp(&qp_, &work_, nullptr);
  }
  daqp(const daqp&) = delete;
  ~daqp() {
    free_daqp_workspace(&work_);
    free_daqp_ldp(&work_);
  }

  ph::vector<double, N> solve(const problem& p) { return solve(p, nullptr); }

  // From these half-spaces on
  ph::vector<double, N> solve(const cone_problem<N>& p, const int* active) {
    qp_.sense = const_cast<int*>(active);     // only read
    qp_.A = const_cast<double*>(p.B.data());  // only read; its rows are the columns of B
    above_.noalias() = -(p.B.transpose() * p.f);
    daqp_update_ldp(DAQP_UPDATE_M | DAQP_UPDATE_d | DAQP_UPDATE_sense, &work_, &qp_);
    daqp_solve(&result_, &work_);
    return p.f + x_;
  }

  // Of each half-space DAQP_ACTIVE if it holds back the solution, else 0
  std::array<int, N> active(const problem& p) {
    ph::vector<double, N> multipliers;
    result_.lam = multipliers.data();  // not elsewhere: they cost time
    solve(p);
    result_.lam = nullptr;
    std::array<int, N> all;
    for (int j = 0; j < N; ++j) all[std::size_t(j)] = multipliers[j] > 0 ? DAQP_ACTIVE : 0;
    return all;
  }

 private:
  ph::matrix<double, N, N> identity_ = ph::matrix<double, N, N>::Identity();
  ph::vector<double, N> above_, below_, x_;
  DAQPProblem qp_{};
  DAQPResult result_{};
  DAQPWorkspace work_{};
};

// The half-spaces that hold back the solution are known, as in the row of ours that begins with them.
template <int N>
class warm_daqp {
 public:
  struct problem : cone_problem<N> {
    problem(const cone_problem<N>& p) : cone_problem<N>(p), active(daqp<N>().active(p)) {}
    std::array<int, N> active;
  };
  static constexpr double tolerance = daqp<N>::tolerance;

  ph::vector<double, N> solve(const problem& p) { return solver_.solve(p, p.active.data()); }

 private:
  daqp<N> solver_;
};

const bool added = add_cone_solver<daqp>(PEER) && add_cone_solver<warm_daqp>(PEER ", warm");

}  // namespace
