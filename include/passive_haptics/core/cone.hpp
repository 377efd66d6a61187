/// @file
/// Projection onto a polyhedral cone given by half-spaces.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <array>

namespace passive_haptics {
namespace detail {

/// Thin QR of a growing set of columns, A = Q R, with the residual r = f - Q Q^T f kept beside it.
/// Q is explicit and reorthogonalised, so r stays orthogonal to the columns at any condition of A.
template <class T, int Rows, int MaxColumns>
class growing_qr {
 public:
  explicit growing_qr(const vector<T, Rows>& f) : r_(f) {}

  int size() const { return size_; }
  const vector<T, Rows>& residual() const { return r_; }

  /// Appends a column; refuses one that depends on the others to rounding: r is orthogonal to it as well, then.
  bool append(const vector<T, Rows>& column, T norm) {
    vector<T, Rows> v = column;
    vector<T, MaxColumns> h = vector<T, MaxColumns>::Zero();
    for (int pass = 0; pass < 3; ++pass) {  // twice is enough (Kahan); once more for nearly parallel columns
      for (int k = 0; k < size_; ++k) {
        const T along = q_.col(k).dot(v);
        h[k] += along;
        v -= along * q_.col(k);
      }
      if (pass == 1 && v.norm() > T(1e-4) * norm) break;
    }
    const T rest = v.norm();
    if (!(rest > rounding_tolerance<T>(Rows) * norm)) return false;
    q_.col(size_) = v / rest;
    upper_.col(size_) = h;
    upper_(size_, size_) = rest;
    c_[size_] = q_.col(size_).dot(r_);
    r_ -= c_[size_] * q_.col(size_);
    ++size_;
    return true;
  }

  /// Keeps the first `count` columns.
  void truncate(int count, const vector<T, Rows>& f) {
    size_ = count;
    r_ = f;
    for (int k = 0; k < size_; ++k) {
      c_[k] = q_.col(k).dot(r_);
      r_ -= c_[k] * q_.col(k);
    }
  }

  /// Least-squares coefficients: R y = Q^T f by back substitution.
  void solve(std::array<T, MaxColumns>& y) const {
    for (int k = size_ - 1; k >= 0; --k) {
      T rest = c_[k];
      for (int l = k + 1; l < size_; ++l) rest -= upper_(k, l) * y[static_cast<std::size_t>(l)];
      y[static_cast<std::size_t>(k)] = rest / upper_(k, k);
    }
  }

 private:
  matrix<T, Rows, MaxColumns> q_;
  matrix<T, MaxColumns, MaxColumns> upper_;
  vector<T, MaxColumns> c_;
  vector<T, Rows> r_;
  int size_ = 0;
};

}  // namespace detail

/// Result of project_onto_half_spaces.
template <class T, int Rows, int Columns>
struct half_space_projection {
  vector<T, Rows> point;  ///< p, the nearest point of the cone.
  vector<T, Columns>
      coefficients;  ///< mu >= 0; mu_j > 0 only where the half-space j is active (b_j . p = 0).
};

/// Nearest point p of the cone { p : B^T p <= 0 } to f.
///
/// By Moreau's decomposition f = p + B mu with mu = argmin |B mu - f|, mu >= 0: a non-negative least-squares
/// problem whose residual is the answer. Lawson and Hanson's active set, over an explicit thin QR: no Gram
/// matrix and no inverse, so p is feasible to rounding at any condition of B. Zero columns restrict nothing.
///
/// B must be finite and f of moderate norm (normalise it first). Ends after at most 6 Columns exchanges; p is
/// then the residual of the last active set.
/// Reference: Lawson, Hanson, Solving Least Squares Problems (1974), ch. 23.
template <class T, int Rows, int Columns>
half_space_projection<T, Rows, Columns> project_onto_half_spaces(const matrix<T, Rows, Columns>& B,
                                                                 const vector<T, Rows>& f) {
  constexpr int most = Rows < Columns ? Rows : Columns;
  constexpr T tolerance = rounding_tolerance<T>(Rows);

  detail::growing_qr<T, Rows, most> qr(f);
  std::array<int, most> member{};  // columns in the active set, in the order of the QR
  std::array<T, most> mu{}, y{};   // feasible and unconstrained coefficients of the members
  std::array<bool, Columns> used{}, refused{};
  const auto at = [](int k) { return static_cast<std::size_t>(k); };

  vector<T, Columns> norms;
  for (int j = 0; j < Columns; ++j) norms[j] = B.col(j).norm();
  const T f_norm = f.norm();

  const auto append = [&](int j, T coefficient) {
    const int k = qr.size();
    if (!qr.append(B.col(j), norms[j])) return false;
    member[at(k)] = j;
    mu[at(k)] = coefficient;
    return used[at(j)] = true;
  };

  // Takes member `out` from the set; those behind it are appended anew.
  const auto remove = [&](int out) {
    const int size = qr.size();
    const auto old_member = member;
    const auto old_mu = mu;
    for (int k = out; k < size; ++k) used[at(old_member[at(k)])] = false;
    qr.truncate(out, f);
    for (int k = out + 1; k < size; ++k) append(old_member[at(k)], old_mu[at(k)]);
  };

  for (int exchange = 0; exchange < 6 * Columns && qr.size() < most; ++exchange) {
    int entering = -1;
    T steepest = tolerance * f_norm;
    for (int j = 0; j < Columns; ++j) {
      if (used[at(j)] || refused[at(j)] || !(norms[j] > T(0))) continue;
      const T violation = B.col(j).dot(qr.residual()) / norms[j];
      if (violation > steepest) {
        steepest = violation;
        entering = j;
      }
    }
    if (entering < 0) break;
    if (!append(entering, T(0))) {
      refused[at(entering)] = true;
      continue;
    }
    bool kept = true;
    while (qr.size() > 0) {
      qr.solve(y);
      int blocking = -1;
      T step = T(1);
      for (int k = 0; k < qr.size(); ++k) {
        if (y[at(k)] > T(0)) continue;
        const T until_zero = mu[at(k)] > T(0) ? mu[at(k)] / (mu[at(k)] - y[at(k)]) : T(0);
        if (blocking < 0 || until_zero < step) {
          step = until_zero;
          blocking = k;
        }
      }
      for (int k = 0; k < qr.size(); ++k) mu[at(k)] += step * (y[at(k)] - mu[at(k)]);
      if (blocking < 0) break;
      if (member[at(blocking)] == entering) kept = false;
      remove(blocking);
    }
    // A newcomer that leaves at once was chosen by rounding; any other exchange lowers the residual.
    if (kept) refused.fill(false);
    else refused[at(entering)] = true;
  }

  half_space_projection<T, Rows, Columns> result{qr.residual(), vector<T, Columns>::Zero()};
  for (int k = 0; k < qr.size(); ++k) result.coefficients[member[at(k)]] = mu[at(k)];
  return result;
}

}  // namespace passive_haptics
