// Eigen's non-negative least squares, which came after 3.4: mu = argmin |B mu - f|, mu >= 0; the residual is
// the nearest point.
#include "../cone_problems.hpp"

#include <unsupported/Eigen/NNLS>

namespace {

using namespace peers;

template <int N>
class eigen_nnls {
 public:
  using problem = cone_problem<N>;
  static constexpr double tolerance = 1e-9;

  ph::vector<double, N> solve(const problem& p) {
    solver_.compute(p.B);
    return p.f - p.B * solver_.solve(p.f);
  }

 private:
  Eigen::NNLS<ph::matrix<double, N, N>> solver_;
};

const bool added = add_cone_solver<eigen_nnls>(PEER);

}  // namespace
