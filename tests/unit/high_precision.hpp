// Numbers of 50 digits, and derivatives in them, as an oracle.
#pragma once

#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/testing/support/derivative.hpp>

#include <boost/multiprecision/cpp_dec_float.hpp>
#include <boost/multiprecision/eigen.hpp>

namespace high_precision {

namespace ph = passive_haptics;

using real =
    boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>, boost::multiprecision::et_off>;

template <int N>
using vec = ph::vector<real, N>;
template <int R, int C>
using mat = ph::matrix<real, R, C>;

template <class T, int R, int C>
mat<R, C> exact(const Eigen::Matrix<T, R, C>& x) {
  return x.template cast<real>();
}

template <class T, int R, int C>
Eigen::Matrix<T, R, C> rounded(const mat<R, C>& x) {
  return x.template cast<T>();
}

// df/ds at 0 to about 40 digits.
template <class F>
auto derivative(F&& f) {
  return passive_haptics::testing::central_difference<real>(f, real(1e-7));
}

// df/dq, a column a joint.
template <int D, int N, class F>
mat<D, N> gradient(F&& f, const vec<N>& q) {
  mat<D, N> J;
  for (int i = 0; i < N; ++i)
    J.col(i) = derivative([&](const real& s) {
      vec<N> moved = q;
      moved[i] += s;
      return vec<D>(f(moved));
    });
  return J;
}

}  // namespace high_precision
