// Problem: the nearest point of { p : B^T p <= 0 } to a unit vector f, B square with Gaussian entries.
#pragma once

#include "comparison.hpp"

#include <passive_haptics/core/matrix.hpp>

#include <cstddef>
#include <vector>

namespace peers {

namespace ph = passive_haptics;

template <int N>
struct cone_problem {
  ph::matrix<double, N, N> B;
  ph::vector<double, N> f;
};

// So many that no branch predictor learns the branches by heart: it does learn 1024, in half of the time.
inline constexpr std::size_t cone_problem_count = 16384;

template <int N>
const std::vector<cone_problem<N>>& cone_problems();

// Worst violation of a half-space b.p / (|b| |f|), worst distance from the solution in 50 digits; throws
// std::runtime_error if that distance is above the tolerance.
template <int N>
errors check_cone_answers(const std::vector<ph::vector<double, N>>& answers, double tolerance);

// A call, as it is with a solver that is a library: no solver is merged with the loop that measures it.
template <class Solver>
[[gnu::noinline]] auto solution(Solver& solver, const typename Solver::problem& problem) {
  return solver.solve(problem);
}

// A solver has
//   - `problem`, made from a cone_problem<N>: the same data, laid out as the solver wants it (not timed);
//   - `solve(problem)`: the nearest point, in a workspace that may be reused (timed);
//   - `tolerance`: how far from the exact point the documentation of its settings allows it to be.
template <template <int> class Solver, int N>
void add_cone_row(const std::string& name) {
  using solver = Solver<N>;
  const auto problems = [] {
    const auto& all = cone_problems<N>();
    return std::vector<typename solver::problem>(all.begin(), all.end());
  };
  const auto check = [problems] {
    solver solve_one;
    std::vector<ph::vector<double, N>> answers;
    for (const auto& problem : problems()) answers.push_back(solve_one.solve(problem));
    return check_cone_answers<N>(answers, solver::tolerance);
  };
  const auto run = [problems](benchmark::State& state) {
    const auto all = problems();
    solver solve_one;
    while (state.KeepRunningBatch(cone_problem_count)) {
      for (const auto& problem : all) {
        auto point = solution(solve_one, problem);
        benchmark::DoNotOptimize(point);
      }
    }
  };
  rows().push_back({"nearest point of a cone, n = " + std::to_string(N), name, check, run});
}

template <template <int> class Solver>
bool add_cone_solver(const std::string& name) {
  add_cone_row<Solver, 2>(name);
  add_cone_row<Solver, 3>(name);
  add_cone_row<Solver, 4>(name);
  add_cone_row<Solver, 6>(name);
  add_cone_row<Solver, 7>(name);
  return true;
}

}  // namespace peers
