/// Projection onto a cone of half-spaces by an active set.
#pragma once

#include <passive_haptics/core/flatten.hpp>
#include <passive_haptics/core/linear/plane_cone.hpp>
#include <passive_haptics/core/linear/updatable_qr.hpp>
#include <passive_haptics/core/nth.hpp>

#include <bit>
#include <limits>

namespace passive_haptics::detail {

/// Lawson and Hanson's non-negative least squares, argmin |B mu - f|, mu >= 0, with an explicit thin QR of
/// the active columns. The residual is the nearest point of the cone. If f violates the same half-spaces as
/// in the previous call, the search starts with the previous active set; otherwise it starts with a guess. At
/// most 6 Columns exchanges follow. Source: Lawson, Hanson, Solving Least Squares Problems (1974), ch. 23.
template <class T, int Rows, int Columns>
class active_set {
 public:
  /// The problem of { p : B^T p <= 0 } and f, which must outlive this object.
  PASSIVE_HAPTICS_INLINE active_set(const matrix<T, Rows, Columns>& B, const vector<T, Rows>& f)
      : b_(B.data()), f_(f.data()), qr_(column::load(f_)) {}

  /// Returns the nearest point to f and updates `start` for a neighbouring problem.
  PASSIVE_HAPTICS_FLATTEN half_space_projection<T, Rows, Columns> nearest(half_space_start& start) {
    prepare();
    const auto products = products_with(qr_.residual());
    const half_space_set violated = bits(products > T(0));
    if (violated == start.violated) append_all(start.active & all);
    else guess(products);
    if (!is_nearest()) exchange();
    start = {members_, violated};
    half_space_projection<T, Rows, Columns> result{{}, vector<T, Columns>::Zero(), members_};
    qr_.clean_residual().store(result.point.data());
    for (int k = 0; k < qr_.size(); ++k) result.coefficients[nth(member_, k)] = nth(mu_, k);
    return result;
  }

 private:
  static constexpr int max_rank = Rows < Columns ? Rows : Columns;
  static constexpr half_space_set all = all_columns<Columns>;
  using qr = updatable_qr<T, Rows, max_rank>;
  using column = typename qr::column;
  using coefficients = typename qr::coefficients;
  using by_half_space = lanes<T, Columns>;

  PASSIVE_HAPTICS_INLINE column half_space(int j) const { return column::load(b_ + j * Rows); }

  PASSIVE_HAPTICS_INLINE void prepare() {
    const T ff = dot(qr_.residual(), qr_.residual());
    vanishing_ = rounding_tolerance<T>(1) * rounding_tolerance<T>(1) * ff;
    const auto square = horizontal_add<T, Columns>([&](int j) {
      const column b = half_space(j);
      return passive_haptics::products(b, b);
    });
    square.store(square_);
    // A column with an underflowing square imposes no constraint
    select(square > std::numeric_limits<T>::min(), T(1) / square, T(0)).store(weight_);
  }

  PASSIVE_HAPTICS_INLINE by_half_space products_with(const column& x) const {
    return horizontal_add<T, Columns>([&](int j) { return passive_haptics::products(half_space(j), x); });
  }

  // Squared distances of x beyond the half-spaces that may enter, from B^T x.
  PASSIVE_HAPTICS_INLINE by_half_space squares_beyond(const by_half_space& products) const {
    const by_half_space x = max(by_half_space(T(0)), products);
    return by_half_space::load(weight_) * x * x;
  }

  // Squared violations by the residual r, and their rounding threshold (infinite if r is only rounding).
  PASSIVE_HAPTICS_INLINE by_half_space squares_beyond() const {
    return squares_beyond(products_with(qr_.residual()));
  }
  PASSIVE_HAPTICS_INLINE T square_of(int roundings) const {
    const T rr = dot(qr_.residual(), qr_.residual());
    const T tolerance = T(roundings) * std::numeric_limits<T>::epsilon();
    return rr > vanishing_ ? tolerance * tolerance * rr : std::numeric_limits<T>::infinity();
  }

  // True if mu > 0 and the residual violates no other half-space. Computes mu.
  PASSIVE_HAPTICS_INLINE bool is_nearest() {
    qr_.solve(mu_);
    if (!all_positive(mu_)) return false;
    if (qr_.size() == max_rank) return true;
    return !(max_value(squares_beyond()) > square_of(1));
  }

  // The half-space that the residual violates by the largest angle above this many roundings, or -1.
  int most_violated(int roundings) const {
    if (qr_.size() == max_rank) return -1;
    const auto worst = find_max(squares_beyond());
    return worst.value > square_of(roundings) ? worst.index : -1;
  }

  PASSIVE_HAPTICS_INLINE void append_all(half_space_set set) {
    for (; set != 0 && qr_.size() < max_rank; set &= set - 1) append(std::countr_zero(set));
  }

  // Appends violated half-spaces regardless of the signs of mu. Updates the products with the residual
  // instead of waiting for it; their error is rounding of |f|, not of |r|.
  PASSIVE_HAPTICS_INLINE void guess(by_half_space products) {
    T along[std::size_t(max_rank)][std::size_t(Columns)];  // of v_k and b_j
    while (qr_.size() < max_rank) {
      const auto [value, j] = find_max(squares_beyond(products));
      if (!(value > T(Rows * Rows) * vanishing_)) return;
      const int k = qr_.size();
      if (!append(j, [&, j = j](int l) { return along[l][j]; })) continue;
      const auto product = products_with(qr_.orthogonal(k));
      products -= qr_.along(k) * product;
      (qr_.inverse_square(k) * product).store(along[k]);
    }
  }

  // Appends half-space j. Returns false if it depends on the members.
  template <class... Along>
  PASSIVE_HAPTICS_INLINE bool append(int j, Along&&... along_b) {
    const int k = qr_.size();
    weight_[j] = T(0);
    if (!qr_.append(half_space(j), square_[j], along_b...)) return false;
    nth(member_, k) = j;
    members_ |= 1u << j;
    return true;
  }

  PASSIVE_HAPTICS_INLINE bool all_positive(const coefficients& y) const {
    bool all_are = true;
    for (int k = 0; k < qr_.size(); ++k) all_are &= nth(y, k) > T(0);
    return all_are;
  }

  // Starts from mu, the least-squares solution of the members. Not inlined because it is rare.
  [[gnu::noinline]] void exchange() {
    while (!all_positive(mu_)) {
      int last = qr_.size() - 1;
      while (nth(mu_, last) > T(0)) --last;
      remove(last);
      qr_.solve(mu_);
    }
    half_space_set refused = 0;
    for (int exchange = 0; exchange < 6 * Columns; ++exchange) {
      // A higher threshold prevents cycling between half-spaces that are almost dependent
      const int roundings = exchange < 3 * Columns ? 1 : 6;
      for (int j = 0; j < Columns; ++j)
        weight_[j] = ((members_ | refused) >> j & 1u) == 0 && square_[j] > std::numeric_limits<T>::min()
                         ? T(1) / square_[j]
                         : T(0);
      const int entering = most_violated(roundings);
      if (entering < 0) return;
      const half_space_set before = members_;
      nth(mu_, qr_.size()) = T(0);
      // A half-space that enters and leaves immediately was selected by rounding
      if (append(entering)) settle();
      if (members_ != before) refused = 0;
      else refused |= 1u << entering;
    }
  }

  // Removes member `out` and appends the members after it again.
  void remove(int out) {
    const int size = qr_.size();
    const auto old_member = member_;
    const auto old_mu = mu_;
    for (int k = out; k < size; ++k) members_ &= ~(1u << nth(old_member, k));
    qr_.truncate(out, column::load(f_));
    for (int k = out + 1; k < size; ++k) {
      nth(mu_, qr_.size()) = nth(old_mu, k);
      append(nth(old_member, k));
    }
  }

  // Moves mu to the least-squares solution of the members and removes members that would become negative.
  void settle() {
    coefficients y;
    for (qr_.solve(y); !all_positive(y); qr_.solve(y)) {
      int blocking = qr_.size();  // none
      T step{};
      for (int k = 0; k < qr_.size(); ++k) {
        if (nth(y, k) > T(0)) continue;
        const T until_zero = nth(mu_, k) > T(0) ? nth(mu_, k) / (nth(mu_, k) - nth(y, k)) : T(0);
        if (blocking == qr_.size() || until_zero < step) {
          step = until_zero;
          blocking = k;
        }
      }
      for (int k = 0; k < qr_.size(); ++k) nth(mu_, k) += step * (nth(y, k) - nth(mu_, k));
      remove(blocking);
    }
    mu_ = y;
  }

  const T* b_;  // B by columns
  const T* f_;
  qr qr_;
  T vanishing_;                                                 // |r|^2 of rounding errors
  T square_[std::size_t(Columns)];                              // |b_j|^2
  alignas(16) T weight_[std::size_t(Columns)];                  // 1 / |b_j|^2 if b_j may enter, else 0
  std::array<int, static_cast<std::size_t>(max_rank)> member_;  // columns in the set, in the order of the QR
  coefficients mu_;
  half_space_set members_ = 0;
};

}  // namespace passive_haptics::detail
