/// @file
/// Projection onto a cone of half-spaces by an active set.
#pragma once

#include <passive_haptics/core/growing_qr.hpp>
#include <passive_haptics/core/plane_cone.hpp>

#include <limits>

namespace passive_haptics::detail {

/// Lawson and Hanson's non-negative least squares, argmin |B mu - f|, mu >= 0, over an explicit thin QR of the active
/// columns; the residual is the nearest point of the cone. Ends after at most 6 Columns exchanges.
/// Reference: Lawson, Hanson, Solving Least Squares Problems (1974), ch. 23.
template <class T, int Rows, int Columns>
class active_set {
 public:
  /// Of { p : B^T p <= 0 } and f.
  active_set(const matrix<T, Rows, Columns>& B, const vector<T, Rows>& f) : b_(B), f_(f), qr_(f) {
    for (int j = 0; j < Columns; ++j) square_[j] = B.col(j).squaredNorm();
  }

  /// The nearest point to f. Inlined, so that the set lives in registers.
  [[gnu::always_inline]] half_space_projection<T, Rows, Columns> nearest(half_space_set start) {
    if (start != 0) begin_with(start);
    const T vanishing = rounding_tolerance<T>(1) * rounding_tolerance<T>(1) * f_.squaredNorm();
    for (int exchange = 0; exchange < 6 * Columns && qr_.size() < most; ++exchange) {
      const int entering = most_violated(vanishing);
      if (entering < 0) break;
      if (!append(entering, T(0))) {
        refused_ |= 1u << entering;
        continue;
      }
      // A newcomer that leaves at once was chosen by rounding; any other exchange lowers the residual.
      if (settle(entering)) refused_ = 0;
      else refused_ |= 1u << entering;
    }
    half_space_projection<T, Rows, Columns> result{qr_.clean_residual(), vector<T, Columns>::Zero(),
                                                   members_};
    for (int k = 0; k < qr_.size(); ++k) result.coefficients[member_[at(k)]] = mu_[at(k)];
    return result;
  }

 private:
  static constexpr int most = Rows < Columns ? Rows : Columns;
  static constexpr std::size_t at(int k) { return static_cast<std::size_t>(k); }
  using coefficients = typename growing_qr<T, Rows, most>::coefficients;

  // The half-space that the residual violates by the largest angle; -1 if none. vanishing: |r|^2 that is rounding.
  int most_violated(T vanishing) const {
    const T rr = qr_.residual().squaredNorm();
    if (!(rr > vanishing)) return -1;
    int worst = -1;
    constexpr T eps = std::numeric_limits<T>::epsilon();
    T worst_product = eps * eps * rr, worst_square = T(1);  // (b . r)^2 and |b|^2
    for (int j = 0; j < Columns; ++j) {
      if (((members_ | refused_) >> j & 1u) != 0) continue;
      const T product = b_.col(j).dot(qr_.residual());
      if (product > T(0) && product * product * worst_square > worst_product * square_[j]) {
        worst_product = product * product;
        worst_square = square_[j];
        worst = j;
      }
    }
    return worst;
  }

  bool append(int j, T coefficient) {
    const int k = qr_.size();
    if (!qr_.append(b_.col(j), square_[j])) return false;
    member_[at(k)] = j;
    mu_[at(k)] = coefficient;
    members_ |= 1u << j;
    return true;
  }

  // Takes member `out` from the set; those behind it are appended anew.
  void remove(int out) {
    const int size = qr_.size();
    const auto old_member = member_;
    const auto old_mu = mu_;
    for (int k = out; k < size; ++k) members_ &= ~(1u << old_member[at(k)]);
    qr_.truncate(out, f_);
    for (int k = out + 1; k < size; ++k) append(old_member[at(k)], old_mu[at(k)]);
  }

  // Moves mu to the least squares of the members, and out of the set those that would become negative on the way.
  // False if the newcomer left.
  bool settle(int entering) {
    bool kept = true;
    while (qr_.size() > 0) {
      coefficients y;
      qr_.solve(y);
      int blocking = -1;
      T step = T(1);
      for (int k = 0; k < qr_.size(); ++k) {
        if (y[at(k)] > T(0)) continue;
        const T until_zero = mu_[at(k)] > T(0) ? mu_[at(k)] / (mu_[at(k)] - y[at(k)]) : T(0);
        if (blocking < 0 || until_zero < step) {
          step = until_zero;
          blocking = k;
        }
      }
      if (blocking < 0) {
        for (int k = 0; k < qr_.size(); ++k) mu_[at(k)] = y[at(k)];
        break;
      }
      for (int k = 0; k < qr_.size(); ++k) mu_[at(k)] += step * (y[at(k)] - mu_[at(k)]);
      if (member_[at(blocking)] == entering) kept = false;
      remove(blocking);
    }
    return kept;
  }

  // All of `start` at once, if they hold f back together; else from nothing.
  void begin_with(half_space_set start) {
    for (int j = 0; j < Columns && qr_.size() < most; ++j) {
      if ((start >> j & 1u) != 0 && square_[j] > T(0)) append(j, T(0));
    }
    qr_.solve(mu_);
    for (int k = 0; k < qr_.size(); ++k) {
      if (mu_[at(k)] > T(0)) continue;
      qr_.truncate(0, f_);
      members_ = 0;
      return;
    }
  }

  const matrix<T, Rows, Columns>& b_;
  const vector<T, Rows>& f_;
  growing_qr<T, Rows, most> qr_;
  vector<T, Columns> square_;                                 // |b_j|^2
  std::array<int, static_cast<std::size_t>(most)> member_{};  // columns in the set, in the order of the QR
  coefficients mu_{};                                         // of the members
  half_space_set members_ = 0, refused_ = 0;
};

}  // namespace passive_haptics::detail
