// The library, and the same active set written out by hand.
#include "cone_problems.hpp"
#include "hand_written_cone.hpp"

#include <passive_haptics/core/linear/space_cone.hpp>

#include <algorithm>

namespace {

using namespace peers;

constexpr double rounding = 1e-9;  // of the worst-conditioned of the problems, generously

template <int N>
struct library {
  using problem = cone_problem<N>;
  static constexpr double tolerance = rounding;

  ph::vector<double, N> solve(const problem& p) { return ph::project_onto_half_spaces(p.B, p.f).point; }
};

// The half-spaces that hold back the solution are known from the problem before: here from the same one.
template <int N>
struct warm {
  struct problem : cone_problem<N> {
    problem(const cone_problem<N>& p) : cone_problem<N>(p) { ph::project_onto_half_spaces(p.B, p.f, start); }
    ph::half_space_start start;
  };
  static constexpr double tolerance = rounding;

  ph::vector<double, N> solve(const problem& p) {
    ph::half_space_start start = p.start;
    return ph::project_onto_half_spaces(p.B, p.f, start).point;
  }
};

// Those of another problem, which was solved before this one.
template <int N>
struct wrong : library<N> {
  ph::half_space_start start;

  ph::vector<double, N> solve(const cone_problem<N>& p) {
    return ph::project_onto_half_spaces(p.B, p.f, start).point;
  }
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
                   add_cone_solver<warm>("ours, warm") && add_cone_solver<wrong>("ours, another's start");

}  // namespace
