/// Closed-form projection onto a cone of three half-spaces in space.
#pragma once

#include <passive_haptics/core/flatten.hpp>
#include <passive_haptics/core/linear/active_set.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/core/scalar/difference_of_products.hpp>

#include <array>

namespace passive_haptics::detail {

/// True if products of four lengths with this square neither overflow nor underflow.
template <class T>
bool is_moderate(T square) {
  constexpr T max_square = sizeof(T) > sizeof(float) ? T(1e30) : T(1e8);
  return square < max_square && square > T(1) / max_square;
}

/// The nearest point is f, its foot on a face or on an edge, or the apex. With the edges d_k = b_i x b_j (i,
/// j, k in cyclic order) and c_j = b_j x f, Lagrange's identity gives for the foot p of f on face j
///
///     |b_j|^2 b_i . p = c_j . (b_j x b_i) = +-c_j . d_k,
///
/// which is also |d_k|^2 mu_i of the foot on the edge of i and j. The signs of a few products therefore
/// select the point. A narrow angle between half-spaces affects only the edges.
template <class T>
class space_cone {
 public:
  using projection = half_space_projection<T, 3, 3>;

  /// The cone { p : B^T p <= 0 } and f, which must outlive this object.
  space_cone(const matrix<T, 3, 3>& B, const vector<T, 3>& f) : f_(f) {
    unrolled<3>([&](auto j) {
      nth(b_, j) = B.col(j);
      square_[j] = nth(b_, j).squaredNorm();
      outside_[j] = nth(b_, j).dot(f);
    });
  }

  /// Finds the nearest point to f. Returns false without changing `answer` if rounding would decide the case.
  PASSIVE_HAPTICS_FLATTEN bool nearest(projection& answer) {
    if (!(outside_[0] > T(0) || outside_[1] > T(0) || outside_[2] > T(0))) {
      answer = {f_, vector<T, 3>::Zero(), 0};
      return true;
    }
    if (!squares_are_moderate()) return false;
    unrolled<3>([&](auto k) { nth(edge_, k) = edge(next(k), previous(k)); });
    for (int j = 0; j < 3; ++j) {
      if (!(outside_[j] > T(0))) continue;
      look_from_face(j);
      if (beyond_next_[j] <= T(0) && beyond_previous_[j] <= T(0)) return lie_on_face(j, answer);
    }
    for (int j = 0; j < 3; ++j) {
      if (!(outside_[j] > T(0))) look_from_face(j);
    }
    for (int k = 0; k < 3; ++k) {
      if (!is_within_edge(k)) continue;
      const T along = nth(edge_, k).dot(f_), third = height(k);
      if (is_flat(k, third)) return false;
      if (!(along * third > T(0))) return lie_on_edge(k, along, answer);
    }
    return lie_at_apex(answer);
  }

 private:
  static constexpr int next(int k) { return k == 2 ? 0 : k + 1; }
  static constexpr int previous(int k) { return k == 0 ? 2 : k - 1; }

  bool squares_are_moderate() const {
    bool moderate = true;
    unrolled<3>([&](auto j) { moderate &= is_moderate(square_[j]) || square_[j] == T(0); });
    return moderate;
  }

  // b_i x b_j to a few roundings, or 0 if parallel to rounding: a foot on one face is then on both
  vector<T, 3> edge(int i, int j) const {
    vector<T, 3> d = cross(nth(b_, i), nth(b_, j));
    const T both = square_[i] * square_[j], narrow = both / T(16);
    if (d.squaredNorm() >= narrow) return d;
    d = accurate_cross(nth(b_, i), nth(b_, j));
    constexpr T parallel = rounding_tolerance<T>(1) * rounding_tolerance<T>(1);
    if (!(d.squaredNorm() > parallel * both)) d.setZero();
    return d;
  }

  // |b_j|^2 b . p for the other two columns b and the foot p of f on face j
  void look_from_face(int j) {
    nth(normal_, j) = cross(nth(b_, j), f_);
    beyond_next_[j] = nth(normal_, j).dot(nth(edge_, previous(j)));
    beyond_previous_[j] = -nth(normal_, j).dot(nth(edge_, next(j)));
  }

  bool lie_on_face(int j, projection& answer) const {
    const T inverse = T(1) / square_[j];
    answer = {inverse * cross(nth(normal_, j), nth(b_, j)), vector<T, 3>::Zero(), 1u << j};
    answer.coefficients[j] = outside_[j] * inverse;
    return true;
  }

  bool is_within_edge(int k) const {
    return beyond_previous_[previous(k)] > T(0) && beyond_next_[next(k)] > T(0);
  }

  // b_k . d_k = det B, the height of edge k over face k
  T height(int k) const { return nth(b_, k).dot(nth(edge_, k)); }
  bool is_flat(int k, T height) const {
    constexpr T tolerance = rounding_tolerance<T>(1) * rounding_tolerance<T>(1);
    return square_[k] > T(0) && !(height * height > tolerance * square_[k] * nth(edge_, k).squaredNorm());
  }

  bool lie_on_edge(int k, T along, projection& answer) const {
    const vector<T, 3>& d = nth(edge_, k);
    const T inverse = T(1) / d.squaredNorm();
    const int i = next(k), j = previous(k);
    answer = {along * inverse * d, vector<T, 3>::Zero(), 1u << i | 1u << j};
    answer.coefficients[i] = beyond_previous_[j] * inverse;
    answer.coefficients[j] = beyond_next_[i] * inverse;
    return true;
  }

  // f = B mu by Cramer's rule; false unless mu >= 0
  bool lie_at_apex(projection& answer) const {
    vector<T, 3> mu;
    for (int k = 0; k < 3; ++k) {
      const T determinant = height(k);
      if (is_flat(k, determinant)) return false;
      mu[k] = nth(edge_, k).dot(f_) / determinant;
      if (!(mu[k] >= T(0))) return false;
    }
    answer = {vector<T, 3>::Zero(), mu, 7u};
    return true;
  }

  const vector<T, 3>& f_;
  std::array<vector<T, 3>, 3> b_, edge_, normal_;  // columns of B, d_k, c_j
  vector<T, 3> square_, outside_;                  // |b_j|^2, b_j . f
  vector<T, 3> beyond_next_, beyond_previous_;     // |b_j|^2 b . p_j for the columns b after and before j
};

/// Tests whether the face or edge of the previous cycle is still nearest, without computing the other edges.
template <class T>
class space_cone_start {
 public:
  using projection = half_space_projection<T, 3, 3>;

  PASSIVE_HAPTICS_INLINE space_cone_start(const matrix<T, 3, 3>& B, const vector<T, 3>& f) : B_(B), f_(f) {}

  /// Finds the nearest point to f if exactly the one or two half-spaces of `active` are active. Otherwise
  /// returns false without changing `answer`.
  PASSIVE_HAPTICS_INLINE bool nearest(half_space_set active, projection& answer) const {
    switch (active) {
      case 1: return is_on_face(0, 1, 2, answer);
      case 2: return is_on_face(1, 2, 0, answer);
      case 4: return is_on_face(2, 0, 1, answer);
      case 3: return is_on_edge(0, 1, 2, answer);
      case 6: return is_on_edge(1, 2, 0, answer);
      case 5: return is_on_edge(2, 0, 1, answer);
      default: return false;
    }
  }

 private:
  vector<T, 3> half_space(int j) const { return B_.col(j); }

  // True if b . x < 0 by more than the rounding of an x with |x|^2 = size
  static bool is_clear(const vector<T, 3>& b, const vector<T, 3>& x, T size) {
    constexpr T tolerance = rounding_tolerance<T>(3) * rounding_tolerance<T>(3);
    const T beyond = b.dot(x);
    return beyond < T(0) && beyond * beyond > tolerance * b.squaredNorm() * size;
  }

  bool is_on_face(int j, int i, int k, projection& answer) const {
    const vector<T, 3> b = half_space(j);
    const T outside = b.dot(f_);
    if (!(outside > T(0))) return false;
    const T square = b.squaredNorm(), inverse = T(1) / square, ff = f_.squaredNorm();
    const vector<T, 3> p = inverse * cross<T>(cross<T>(b, f_), b);
    if (!is_moderate(square) || !is_clear(half_space(i), p, ff) || !is_clear(half_space(k), p, ff))
      return false;
    answer = {p, vector<T, 3>::Zero(), 1u << j};
    answer.coefficients[j] = outside * inverse;
    return true;
  }

  // Foot of f on the edge d of faces i and j, unless the angle is narrow
  bool is_on_edge(int i, int j, int k, projection& answer) const {
    const vector<T, 3> bi = half_space(i), bj = half_space(j), d = cross(bi, bj);
    const T mu_i = d.dot(cross(f_, bj));  // times |d|^2
    if (!(mu_i > T(0))) return false;
    const T mu_j = d.dot(cross(bi, f_));
    if (!(mu_j > T(0))) return false;
    const T i_square = bi.squaredNorm(), j_square = bj.squaredNorm(), square = d.squaredNorm();
    if (!is_moderate(i_square) || !is_moderate(j_square) || square < i_square * j_square / T(16))
      return false;
    const T along = d.dot(f_);
    const vector<T, 3> p = along * d;  // times |d|^2
    if (!is_clear(half_space(k), p, along * along * square)) return false;
    const T inverse = T(1) / square;
    answer = {inverse * p, vector<T, 3>::Zero(), 1u << i | 1u << j};
    answer.coefficients[i] = mu_i * inverse;
    answer.coefficients[j] = mu_j * inverse;
    return true;
  }

  const matrix<T, 3, 3>& B_;
  const vector<T, 3>& f_;
};

/// Nearest point of { p : B^T p <= 0 } to f, by an active set if rounding would decide the case.
template <class T>
half_space_projection<T, 3, 3> nearest_in_space(const matrix<T, 3, 3>& B, const vector<T, 3>& f,
                                                half_space_start& start) {
  half_space_projection<T, 3, 3> answer;
  if ((start.active != 0 && space_cone_start<T>(B, f).nearest(start.active, answer)) ||
      space_cone<T>(B, f).nearest(answer)) {
    start.active = answer.active;
    return answer;
  }
  return active_set<T, 3, 3>(B, f).nearest(start);
}

}  // namespace passive_haptics::detail
