// The active set of core/linear/cone.hpp written out by hand over plain arrays: what the library's solver is
// measured against.
#pragma once

#include <cmath>
#include <limits>

namespace hand_written {

template <int N>
using numbers = double[N];

template <int N>
double dot(const numbers<N>& a, const numbers<N>& b) {
  double sum = 0;
  for (int i = 0; i < N; ++i) sum += a[i] * b[i];
  return sum;
}

// y -= s x
template <int N>
void subtract(double s, const numbers<N>& x, numbers<N>& y) {
  for (int i = 0; i < N; ++i) y[i] -= s * x[i];
}

// Nearest point p of { p : b_j . p <= 0 } to f, by Lawson and Hanson: f - p = B mu, mu >= 0, |p| least.
// The members b_m1 .. b_mk of the active set are kept as Q R, Q reorthogonalised, and p = f - Q Q^T f.
template <int Rows, int Columns>
class cone {
 public:
  // Column j of B is b[j].
  void project(const numbers<Rows> (&b)[Columns], const numbers<Rows>& f) {
    b_ = b;
    f_ = &f;
    start();
    for (int round = 0; round < 6 * Columns; ++round) {
      const int j = most_violated();
      if (j < 0) break;
      if (append(j)) become_feasible();
      else refused_ |= bit(j);
    }
    for (int j = 0; j < Columns; ++j) coefficient_[j] = 0;
    for (int c = 0; c < size_; ++c) coefficient_[member_[c]] = mu_[c];
  }

  const numbers<Rows>& point() const { return p_; }
  const numbers<Columns>& coefficients() const { return coefficient_; }

 private:
  static constexpr int max_active = Rows < Columns ? Rows : Columns;
  static constexpr double eps = std::numeric_limits<double>::epsilon();

  static constexpr unsigned bit(int j) { return 1u << j; }
  static constexpr double square(double x) { return x * x; }

  void start() {
    size_ = 0;
    used_ = refused_ = 0;
    for (int i = 0; i < Rows; ++i) p_[i] = (*f_)[i];
    for (int j = 0; j < Columns; ++j) squared_norm_[j] = dot(b_[j], b_[j]);
    rounding_ = square(4 * Rows * eps) * dot(*f_, *f_);
  }

  // The half-space outside of which p lies farthest, beyond rounding; -1 if there is none.
  int most_violated() const {
    int found = -1;
    double farthest = 0;  // squared distance
    if (size_ == max_active) return found;
    for (int j = 0; j < Columns; ++j) {
      if ((used_ | refused_) & bit(j)) continue;
      const double outside = dot(b_[j], p_);
      if (!(outside > 0 && square(outside) > rounding_ * squared_norm_[j])) continue;
      if (const double distance = square(outside) / squared_norm_[j]; distance > farthest) {
        farthest = distance;
        found = j;
      }
    }
    return found;
  }

  // Takes b_j into the active set; not if it depends on the members to rounding.
  bool append(int j) {
    const int k = size_;
    double v[Rows];
    for (int i = 0; i < Rows; ++i) v[i] = b_[j][i];
    make_orthogonal<false>(v);
    make_orthogonal<true>(v);  // twice is enough (Kahan)
    double rest = dot(v, v);
    if (!(rest > square(64 * eps) * squared_norm_[j])) return false;
    if (k > 0 && rest < 1e-8 * squared_norm_[j]) {  // but for nearly parallel columns
      make_orthogonal<true>(v);
      rest = dot(v, v);
    }
    const double length = std::sqrt(rest), scale = 1 / length;
    for (int i = 0; i < Rows; ++i) Q_[k][i] = v[i] * scale;
    R_[k][k] = length;
    z_[k] = dot(Q_[k], p_);
    subtract(z_[k], Q_[k], p_);
    member_[k] = j;
    mu_[k] = 0;
    used_ |= bit(j);
    ++size_;
    return true;
  }

  // To the members; what v is along them goes into R.
  template <bool Again>
  void make_orthogonal(numbers<Rows>& v) {
    for (int c = 0; c < size_; ++c) {
      const double along = dot(Q_[c], v);
      R_[c][size_] = Again ? R_[c][size_] + along : along;
      subtract(along, Q_[c], v);
    }
  }

  // Moves mu towards the least-squares solution y of the active set; members whose mu reaches 0 leave on the
  // way.
  void become_feasible() {
    for (bool newcomer = true; size_ > 0; newcomer = false) {
      double y[max_active];
      solve(y);
      double step = 1;
      int leaving = -1;
      for (int c = 0; c < size_; ++c) {
        if (y[c] > 0) continue;
        const double until_zero = mu_[c] > 0 ? mu_[c] / (mu_[c] - y[c]) : 0;
        if (leaving < 0 || until_zero < step) {
          step = until_zero;
          leaving = c;
        }
      }
      for (int c = 0; c < size_; ++c) mu_[c] = leaving < 0 ? y[c] : mu_[c] + step * (y[c] - mu_[c]);
      if (leaving < 0) return;
      // Who would leave at once was chosen by rounding
      if (newcomer && leaving == size_ - 1) refused_ |= bit(member_[leaving]);
      remove(leaving);
    }
  }

  // R y = Q^T f
  void solve(numbers<max_active>& y) const {
    for (int c = size_ - 1; c >= 0; --c) {
      double rest = z_[c];
      for (int d = c + 1; d < size_; ++d) rest -= R_[c][d] * y[d];
      y[c] = rest / R_[c][c];
    }
  }

  // Those behind the leaving member are appended anew.
  void remove(int leaving) {
    int later[max_active] = {}, count = 0;
    double later_mu[max_active] = {};
    for (int c = leaving; c < size_; ++c) used_ &= ~bit(member_[c]);
    for (int c = leaving + 1; c < size_; ++c, ++count) {
      later[count] = member_[c];
      later_mu[count] = mu_[c];
    }
    size_ = leaving;
    for (int i = 0; i < Rows; ++i) p_[i] = (*f_)[i];
    for (int c = 0; c < size_; ++c) {
      z_[c] = dot(Q_[c], p_);
      subtract(z_[c], Q_[c], p_);
    }
    for (int k = 0; k < count; ++k)
      if (append(later[k])) mu_[size_ - 1] = later_mu[k];
  }

  const numbers<Rows>* b_;
  const numbers<Rows>* f_;
  double p_[Rows], coefficient_[Columns], squared_norm_[Columns];
  double Q_[max_active][Rows], R_[max_active][max_active];  // Q by columns, R by rows
  double z_[max_active], mu_[max_active];                   // Q^T f, and the coefficients of the members
  double rounding_;
  int member_[max_active], size_;
  unsigned used_, refused_;
};

}  // namespace hand_written
