// eiquadprog, Goldfarb and Idnani's dual active set, in its fixed-size form: min |p|^2 / 2 - f.p, -B^T p >=
// 0.
#include "../cone_problems.hpp"

#include <eiquadprog/eiquadprog-rt.hpp>

namespace {

using namespace peers;

template <int N>
class eiquadprog_rt {
 public:
  struct problem {
    problem(const cone_problem<N>& p) : A(-p.B.transpose()), g(-p.f) {}
    ph::matrix<double, N, N> A;
    ph::vector<double, N> g;
  };
  static constexpr double tolerance = 1e-9;

  ph::vector<double, N> solve(const problem& p) {
    ph::vector<double, N> point;
    solver_.solve_quadprog(identity_, p.g, no_rows_, none_, p.A, zero_, point);
    return point;
  }

 private:
  const ph::matrix<double, N, N> identity_ = ph::matrix<double, N, N>::Identity();
  const ph::vector<double, N> zero_ = ph::vector<double, N>::Zero();
  const ph::matrix<double, 0, N> no_rows_;
  const ph::vector<double, 0> none_;
  eiquadprog::solvers::RtEiquadprog<N, 0, N> solver_;
};

const bool added = add_cone_solver<eiquadprog_rt>(PEER);

}  // namespace
