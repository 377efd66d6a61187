/// Least-norm non-negative solution of linear equations.
#pragma once

#include <passive_haptics/core/linear/column_subset.hpp>
#include <passive_haptics/core/linear/normal_equations.hpp>
#include <passive_haptics/core/linear/plane_cone.hpp>

#include <algorithm>
#include <bit>
#include <limits>

namespace passive_haptics::detail {

/// The x >= 0 of least |x| with V x = f, found from a basic solution.
///
/// The dual x_i = max(0, v_i . l) is piecewise linear in the D unknowns l, with one piece per set of columns.
/// Newton's method for l uses normal equations and ends when a step stays in its piece.
///
/// If the normal equations are ill-conditioned or Newton's method does not end soon, a primal active set
/// takes over: x moves to the least-norm solution on its set, ignoring signs; a blocking column leaves, and
/// all columns with v_i . l > 0 enter. V x = f holds throughout and |x| decreases, so the search is finite.
/// Source: Nocedal, Wright, Numerical Optimization (2006), ch. 16.5.
template <class T, int D, int M>
class least_norm {
 public:
  /// V (D x M) and f, which must outlive this object.
  PASSIVE_HAPTICS_INLINE least_norm(const matrix<T, D, M>& V, const vector<T, D>& f) : v_(V), f_(f) {
    unrolled<D>([&](auto k) PASSIVE_HAPTICS_INLINE { rows_[k] = row(V, k); });
  }

  /// Finds x of the columns in `usable`. basis: columns with V x = f for an x >= 0, of any number, possibly
  /// parallel. Returns false, with an invalid x, if rounding puts f outside their range. Cost: usually normal
  /// equations of 1 or 2 pieces; 2 to 4 column_subsets for condition numbers above about 1000.
  PASSIVE_HAPTICS_INLINE bool solve(const lane_mask<T, M>& basis, const lane_mask<T, M>& usable,
                                    vector<T, M>& x) {
    const bool in_a_face = !(usable == columns::of(all_columns<M>));
    return (!in_a_face && solve_by_newton(basis, x)) || solve_by_active_set(bits(basis), bits(usable), x);
  }

 private:
  using subset_type = column_subset<T, D, M>;
  using per_column = typename subset_type::per_column;
  using columns = lane_mask<T, M>;

  // V^T l
  PASSIVE_HAPTICS_INLINE per_column products_with(const vector<T, D>& l) const {
    per_column y = l[0] * rows_[0];
    unrolled<D - 1>([&](auto k) { y += l[k + 1] * rows_[k + 1]; });
    return y;
  }

  // f - V x
  PASSIVE_HAPTICS_INLINE vector<T, D> rest_of_f(const per_column& x) const {
    vector<T, D> left;
    unrolled<D>([&](auto k) { left[k] = f_[k] - dot(rows_[k], x); });
    return left;
  }

  // False if the normal equations are ill-conditioned
  PASSIVE_HAPTICS_INLINE bool solve_by_newton(columns in_set, vector<T, M>& x) const {
    const per_column none(T(0));
    for (int piece = 0; piece < 6; ++piece) {
      const normal_equations<T, D, M> A(rows_, in_set);
      if (!A.are_sharp()) return false;
      per_column u = products_with(A.solve(f_));
      columns positive = u > none;
      if (positive == in_set) {
        u += products_with(A.solve(rest_of_f(select(in_set, u, none))));
        positive = u > none;
        if (positive == in_set) {
          select(in_set, u, none).store(x.data());
          return true;
        }
      }
      in_set = positive;
    }
    return false;
  }

  [[gnu::noinline]] bool solve_by_active_set(half_space_set basis, half_space_set usable, vector<T, M>& x) {
    if (std::popcount(basis) < D) basis = completed(basis, usable);
    const int rank = std::min(std::popcount(basis), D);
    per_column in_set = weights(basis);
    const per_column allowed = weights(usable);
    for (int piece = 0; piece < 6 * M; ++piece) {
      const subset_type subset(rows_, f_, in_set);
      if (!subset.reaches(rounding_tolerance<T>(D * M))) return false;
      const auto solution = subset.solution();
      const per_column &u = solution.first, &size = solution.second;
      const per_column noise = T(4 * D) * std::numeric_limits<T>::epsilon() * size;
      const per_column entering = select(u > noise, allowed - in_set, T(0));
      const per_column leaving = select(u < -noise, in_set, T(0));
      const bool any_leaves = count(leaving) > T(0);
      // The solution on a basis is unique, so negative entries are rounding errors
      if (any_leaves && count(in_set) > T(rank)) {
        step_towards(u, leaving, in_set, x);
        continue;
      }
      take(u, in_set, x);
      if (count(entering) == T(0)) {
        if (any_leaves) take_without(leaving, in_set, x);
        else refine(subset, in_set, x);
        return true;
      }
      in_set += entering;
    }
    return true;
  }

  PASSIVE_HAPTICS_INLINE static per_column weights(half_space_set set) {
    vector<T, M> w;
    unrolled<M>([&](auto i) { w[i] = static_cast<T>(set >> i & 1u); });
    return per_column::load(w.data());
  }

  PASSIVE_HAPTICS_INLINE static T count(const per_column& set) { return dot(set, per_column(T(1))); }

  // x = u on the set, with negative rounding errors set to 0
  PASSIVE_HAPTICS_INLINE static void take(const per_column& u, const per_column& in_set, vector<T, M>& x) {
    select(u > T(0), in_set * u, T(0)).store(x.data());
  }

  // Adds the solution for the remainder of f, so that V x = f to rounding of its terms
  PASSIVE_HAPTICS_INLINE void refine(const subset_type& subset, const per_column& in_set,
                                     vector<T, M>& x) const {
    const per_column made = per_column::load(x.data());
    take(subset.solution_of(rest_of_f(made)) + made, in_set, x);
  }

  // Removes columns that are 0 to rounding, so that the others produce all of f.
  [[gnu::noinline]] void take_without(const per_column& leaving, per_column in_set, vector<T, M>& x) const {
    in_set -= leaving;
    take(subset_type(rows_, f_, in_set).solution().first, in_set, x);
  }

  // Moves x towards u until the first decreasing entry reaches 0 and leaves the set.
  static void step_towards(const per_column& to, const per_column& leaving, per_column& in_set,
                           vector<T, M>& x) {
    vector<T, M> u, leaves, member;
    to.store(u.data());
    leaving.store(leaves.data());
    in_set.store(member.data());
    T step = T(1);
    int blocking = -1;
    for (int i = 0; i < M; ++i) {
      if (leaves[i] == T(0)) continue;
      const T until_zero = x[i] / (x[i] - u[i]);
      if (blocking < 0 || until_zero < step) {
        step = until_zero;
        blocking = i;
      }
    }
    for (int i = 0; i < M; ++i) x[i] = std::max(T(0), x[i] + member[i] * step * (u[i] - x[i]));
    x[blocking] = member[blocking] = T(0);
    in_set = per_column::load(member.data());
  }

  // Adds the most independent columns until the basis spans the same space as the usable columns.
  [[gnu::noinline]] half_space_set completed(half_space_set basis, half_space_set usable) const {
    matrix<T, D, M> rest = v_;
    half_space_set next = basis;
    for (int k = 0; k < D; ++k) {
      int farthest = -1;
      T largest = rounding_tolerance<T>(D) * rounding_tolerance<T>(D);
      for (int i = 0; i < M; ++i) {
        const half_space_set candidates = next != 0 ? next : usable;
        const T square = rest.col(i).squaredNorm(), whole = v_.col(i).squaredNorm();
        if ((candidates >> i & 1u) == 0 || !(square > largest * whole)) continue;
        largest = square / whole;
        farthest = i;
      }
      if (farthest < 0) break;
      next &= ~(1u << farthest);
      basis |= 1u << farthest;
      const vector<T, D> axis = rest.col(farthest).normalized();
      for (int pass = 0; pass < 2; ++pass) rest -= axis * (axis.transpose() * rest);
    }
    return basis;
  }

  const matrix<T, D, M>& v_;
  const vector<T, D>& f_;
  per_column rows_[std::size_t(D)];  // V by rows
};

}  // namespace passive_haptics::detail
