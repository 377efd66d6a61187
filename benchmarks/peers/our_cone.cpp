// The library, and the same active set written out by hand. The multipliers stay in the solver, as a peer's
// do: a compiler that saw that nobody reads them would leave them out.
#include "cone_problems.hpp"
#include "hand_written_cone.hpp"

#include <passive_haptics/core/linear/cone.hpp>

#include <algorithm>

namespace {

using namespace peers;

constexpr double rounding = 1e-9;  // of the worst-conditioned of the problems, generously

template <int N>
class library {
 public:
  using problem = cone_problem<N>;
  static constexpr double tolerance = rounding;

  ph::vector<double, N> solve(const problem& p) {
    found_ = ph::project_onto_half_spaces(p.B, p.f);
    return found_.point;
  }

 private:
  ph::half_space_projection<double, N, N> found_;
};

// The half-spaces that hold back the solution are known from the problem before: here from the same one.
template <int N>
class warm {
 public:
  struct problem : cone_problem<N> {
    problem(const cone_problem<N>& p) : cone_problem<N>(p) { ph::project_onto_half_spaces(p.B, p.f, start); }
    ph::half_space_start start;
  };
  static constexpr double tolerance = rounding;

  ph::vector<double, N> solve(const problem& p) {
    ph::half_space_start start = p.start;
    found_ = ph::project_onto_half_spaces(p.B, p.f, start);
    return found_.point;
  }

 private:
  ph::half_space_projection<double, N, N> found_;
};

template <int N>
class by_hand {
 public:
  struct problem {
    problem(const cone_problem<N>& p) {
      for (int j = 0; j < N; ++j) std::copy_n(p.B.col(j).data(), N, b[j]);
      std::copy_n(p.f.data(), N, f);
    }
    hand_written::numbers<N> b[N], f;
  };
  static constexpr double tolerance = rounding;

  ph::vector<double, N> solve(const problem& p) {
    cone_.project(p.b, p.f);
    return ph::vector<double, N>(cone_.point());
  }

 private:
  hand_written::cone<N, N> cone_;
};

const bool added = add_cone_solver<library>(ours) && add_cone_solver<by_hand>("the same by hand") &&
                   add_cone_solver<warm>("ours, warm");

}  // namespace
