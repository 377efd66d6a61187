// OSQP, an operator splitting: cold (but for its step size, which adapts) and silent, otherwise as it comes:
// stops at residuals and a duality gap of 1e-3.
#include "../cone_problems.hpp"

#include <osqp.h>

#include <array>

namespace {

using namespace peers;

template <int N>
class osqp {
 public:
  struct problem {
    problem(const cone_problem<N>& p) : A(p.B.transpose()), q(-p.f) {}
    ph::matrix<double, N, N> A;  // all entries, column by column: a sparse matrix without zeros
    ph::vector<double, N> q;
  };
  static constexpr double tolerance = 0.1;  // distance <= sqrt(2 gap), and a little for the residuals

  osqp() {
    std::array<OSQPInt, N + 1> diagonal, columns;
    std::array<OSQPInt, std::size_t(N * N)> rows;
    for (std::size_t k = 0; k < diagonal.size(); ++k) {
      diagonal[k] = OSQPInt(k);
      columns[k] = N * OSQPInt(k);
    }
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k] = OSQPInt(k % N);
    ph::matrix<double, N, N> A = ph::matrix<double, N, N>::Ones();
    ph::vector<double, N> one = ph::vector<double, N>::Ones(), zero = ph::vector<double, N>::Zero(),
                          below = ph::vector<double, N>::Constant(-OSQP_INFTY);
    OSQPCscMatrix P_sparse, A_sparse;
    OSQPCscMatrix_set_data(&P_sparse, N, N, N, one.data(), diagonal.data(), diagonal.data());
    OSQPCscMatrix_set_data(&A_sparse, N, N, N * N, A.data(), rows.data(), columns.data());
    OSQPSettings settings;
    osqp_set_default_settings(&settings);
    settings.verbose = 0;
    settings.warm_starting = 0;
    osqp_setup(&solver_, &P_sparse, zero.data(), &A_sparse, below.data(), zero.data(), N, N, &settings);
  }
  osqp(const osqp&) = delete;
  ~osqp() { osqp_cleanup(solver_); }

  ph::vector<double, N> solve(const problem& p) {
    osqp_update_data_vec(solver_, p.q.data(), nullptr, nullptr);
    osqp_update_data_mat(solver_, nullptr, nullptr, 0, p.A.data(), nullptr, N * N);
    osqp_solve(solver_);
    return ph::vector<double, N>(solver_->solution->x);
  }

 private:
  OSQPSolver* solver_ = nullptr;
};

const bool added = add_cone_solver<osqp>(PEER);

}  // namespace
