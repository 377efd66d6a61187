/// A mechanism with brakes on some of its joints.
#pragma once

#include <passive_haptics/mechanism/adaptors/wrapped_mechanism.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace passive_haptics {

namespace detail {
template <int Count, int... Chosen>
inline constexpr bool are_different_numbers = [] {
  bool seen[std::size_t(Count)] = {};
  const auto is_new = [&](int i) { return 0 <= i && i < Count && !std::exchange(seen[i], true); };
  return (is_new(Chosen) && ...);
}();
}  // namespace detail

/// The mechanism M with selected brakes, by number from 0; the other joints are free:
///
///     const ph::braked_joints<decltype(arm), 0, 2> light(arm);  // the first and last of three joints
///
/// Without a transmission, brake i is on joint i; brakes on tendons keep theirs. Fewer forces can be
/// displayed, because F must not load the free joints (design/displayable.hpp).
template <class M, int... Brakes>
class braked_joints : public wrapped_mechanism<M> {
  static_assert(sizeof...(Brakes) > 0 && detail::are_different_numbers<M::brake_count, Brakes...>,
                "passive_haptics: braked_joints<M, i, j, ...> needs at least one number of a brake, each "
                "other than the others and from 0 to brake_count - 1.");
  using T = typename M::scalar;
  static constexpr int m = static_cast<int>(sizeof...(Brakes));
  template <class Transmission, int Rows>
  using rows_of = matrix<typename std::remove_cvref_t<Transmission>::Scalar, Rows, M::dof>;

 public:
  static constexpr int brake_count = m;  ///< Number of brakes m.

  /// Selects brakes of this mechanism.
  explicit braked_joints(M mechanism) : wrapped_mechanism<M>(std::move(mechanism)) {}

  /// Selected rows of T (m x n).
  matrix<T, m, M::dof> transmission() const
    requires(!detail::transmission_depends_on_pose<M>)
  {
    if constexpr (detail::transmission_is_constant<M>)
      return chosen(transmission_matrix<M>(this->mechanism().transmission()));
    else return chosen(matrix<T, M::dof, M::dof>(matrix<T, M::dof, M::dof>::Identity()));
  }
  /// Selected rows of T (m x n) for q or a pose.
  template <class Q, class X = M>
  auto transmission(const Q& q) const -> rows_of<decltype(std::declval<const X&>().transmission(q)), m> {
    return chosen(rows_of<decltype(this->mechanism().transmission(q)), M::brake_count>(
        this->mechanism().transmission(q)));
  }
  /// Selected rows of Td qd (m).
  vector<T, m> brake_bias_acceleration(const joint_vector<M>& q, const joint_vector<M>& qd) const
    requires requires(const M& inner) { inner.brake_bias_acceleration(q, qd); }
  {
    return chosen(brake_vector<M>(this->mechanism().brake_bias_acceleration(q, qd)));
  }

 private:
  template <class S, int Columns>
  static matrix<S, m, Columns> chosen(const matrix<S, M::brake_count, Columns>& all) {
    matrix<S, m, Columns> some;
    int row = 0;
    ((some.row(row++) = all.row(Brakes)), ...);
    return some;
  }
};

}  // namespace passive_haptics
