#include "cone_problems.hpp"

#include "../../tests/unit/core/cone_oracle.hpp"

#include <passive_haptics/core/linear/cone.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace peers {

template <int N>
const std::vector<cone_problem<N>>& cone_problems() {
  static const std::vector<cone_problem<N>> problems = [] {
    ph::testing::random_source random(seed);
    std::vector<cone_problem<N>> all(cone_problem_count);
    for (auto& [B, f] : all) {
      for (int j = 0; j < N; ++j) B.col(j) = random.normal_vector<double, N>();
      f = random.direction<double, N>();
    }
    return all;
  }();
  return problems;
}

namespace {

template <int N>
oracle::column exact(const ph::vector<double, N>& x) {
  return {x.data(), x.data() + N};
}

template <int N>
const std::vector<oracle::column>& exact_answers() {
  static const std::vector<oracle::column> answers = [] {
    std::vector<oracle::column> all;
    for (const auto& [B, f] : cone_problems<N>())
      all.push_back(oracle::nearest_point(B, f, ph::project_onto_half_spaces(B, f).active));
    return all;
  }();
  return answers;
}

}  // namespace

template <int N>
errors check_cone_answers(const std::vector<ph::vector<double, N>>& answers, double tolerance) {
  double violation = 0, distance = 0;
  for (std::size_t k = 0; k < answers.size(); ++k) {
    const auto& [B, f] = cone_problems<N>()[k];
    const oracle::column p = exact<N>(answers[k]);
    for (int j = 0; j < N; ++j) {
      const oracle::column b = exact<N>(B.col(j));
      const oracle::real outside = oracle::dot(b, p) / (oracle::norm(b) * oracle::norm(exact<N>(f)));
      violation = std::max(violation, static_cast<double>(outside));
    }
    oracle::column difference = p;
    for (std::size_t i = 0; i < N; ++i) difference[i] -= exact_answers<N>()[k][i];
    const double off = static_cast<double>(oracle::norm(difference));
    distance = std::max(distance, off);
    if (!(off <= tolerance)) {
      std::ostringstream error;
      error << "n = " << N << ", seed " << seed << ", problem " << k << ": the solution "
            << answers[k].transpose() << " is " << off << " from the exact one: expected at most "
            << tolerance << ". Is the solver set up for this problem?";
      throw std::runtime_error(error.str());
    }
  }
  return {{"violation", violation}, {"distance", distance}};
}

#define PEERS_CONE_SIZE(N)                                      \
  template const std::vector<cone_problem<N>>& cone_problems(); \
  template errors check_cone_answers<N>(const std::vector<ph::vector<double, N>>&, double);
PEERS_CONE_SIZE(2)
PEERS_CONE_SIZE(3)
PEERS_CONE_SIZE(4)
PEERS_CONE_SIZE(6)
PEERS_CONE_SIZE(7)

}  // namespace peers
