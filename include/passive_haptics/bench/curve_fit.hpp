/// Least-squares fit of the constants of a formula, with standard errors.
#pragma once

#include <passive_haptics/bench/bench_sample.hpp>
#include <passive_haptics/core/linear/cholesky.hpp>
#include <passive_haptics/core/scalar/dual_number.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace passive_haptics {

/// N constants of a formula.
template <int N>
struct curve_fit {
  vector<double, N> value = vector<double, N>::Zero();  ///< p
  /// s^2 (J^T J)^-1 with the derivatives J by p; infinite if the samples do not determine p.
  matrix<double, N, N> covariance = matrix<double, N, N>::Zero();
  double deviation = 0;  ///< s, standard deviation of the samples from the formula, in their unit.

  estimate operator[](int i) const { return {value[i], std::sqrt(covariance(i, i))}; }  ///< Constant i.
  /// f(value) with its standard error to first order, by the derivatives of f.
  template <class F>
  estimate of(F&& f) const {
    vector<dual_number<double, N>, N> p;
    for (int i = 0; i < N; ++i) p[i] = dual_number<double, N>::variable(value[i], i);
    const dual_number<double, N> y = f(p);
    const double variance = y.derivatives().dot(covariance * y.derivatives());
    return {y.value(), std::isfinite(variance) ? std::sqrt(std::max(variance, 0.0))
                                               : std::numeric_limits<double>::infinity()};
  }
};

/// argmin_p sum_k residual(sample_k, p)^2 from `start` by Levenberg and Marquardt: (A + lambda diag A) dp =
/// -J^T r with A = J^T J; J by automatic differentiation. A residual that is not finite marks p as out of
/// range. The errors of the samples are assumed independent and of equal size. Throws std::invalid_argument
/// if there are no more samples than constants, or the residuals at `start` are not finite.
template <int N, class Samples, class Residual>
curve_fit<N> fit_curve(const Samples& samples, const vector<double, N>& start, const Residual& residual) {
  using variable = dual_number<double, N>;
  constexpr int max_steps = 100;
  constexpr double no_gain = 1e-12;
  // [J r]^T [J r]
  const auto squares_at = [&](const vector<double, N>& value) {
    vector<variable, N> p;
    for (int i = 0; i < N; ++i) p[i] = variable::variable(value[i], i);
    matrix<double, N + 1, N + 1> squares = matrix<double, N + 1, N + 1>::Zero();
    for (const auto& s : samples) {
      const variable r = residual(s, p);
      vector<double, N + 1> row;
      row.template head<N>() = r.derivatives();
      row[N] = r.value();
      squares += row * row.transpose();
    }
    return squares;
  };

  detail::refuse_unless(std::ssize(samples) > N, "samples of a fit", std::ssize(samples),
                        detail::indexed("more than its ", N, " constants: record longer or faster"));
  curve_fit<N> fit{.value = start};
  matrix<double, N + 1, N + 1> least = squares_at(start);
  detail::refuse_unless(std::isfinite(least(N, N)), "sum of the squared residuals where a fit begins",
                        least(N, N), "a finite number: pass finite samples, in the units of the formula");
  double lambda = 1e-3;
  for (int step = 0; step < max_steps && lambda < 1e12; ++step) {
    matrix<double, N, N> damped = least.template topLeftCorner<N, N>();
    damped.diagonal() *= 1 + lambda;
    const vector<double, N> g = least.template topRightCorner<N, 1>();
    const vector<double, N> next = fit.value - vector<double, N>(cholesky<double, N>(damped).solve(g));
    const auto there = squares_at(next);
    const double gain = least(N, N) - there(N, N);
    if (!(gain >= 0)) {
      lambda *= 10;
      continue;
    }
    const bool settled = gain <= no_gain * least(N, N);
    fit.value = next;
    least = there;
    lambda /= 10;
    if (settled) break;
  }

  const auto freedom = static_cast<double>(std::ssize(samples)) - N;
  fit.deviation = std::sqrt(least(N, N) / freedom);
  // Columns scaled to unit length, so that singularity does not depend on units
  const matrix<double, N, N> A = least.template topLeftCorner<N, N>();
  const vector<double, N> size = A.diagonal().cwiseSqrt();
  const matrix<double, N, N> scale = size.cwiseInverse().asDiagonal();
  const cholesky<double, N> scaled(matrix<double, N, N>(scale * A * scale));
  const matrix<double, N, N> inverse = scaled.solve(matrix<double, N, N>(matrix<double, N, N>::Identity()));
  constexpr double max_variance = 1e12;  // variance inflation above which rounding dominates
  if (scaled.is_positive_definite() && inverse.diagonal().maxCoeff() < max_variance)
    fit.covariance = fit.deviation * fit.deviation * scale * inverse * scale;
  else fit.covariance.setConstant(std::numeric_limits<double>::infinity());
  return fit;
}

}  // namespace passive_haptics
