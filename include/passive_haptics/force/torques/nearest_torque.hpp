/// Brake torques with the force nearest to a desired one: the generator form.
#pragma once

#include <passive_haptics/brake/torque_interval.hpp>
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/linear/generated_cone.hpp>
#include <passive_haptics/core/linear/prioritised_least_squares.hpp>

#include <cmath>
#include <limits>

namespace passive_haptics {

/// Torques of brakes with signs s: s_i t_i <= 0 and |t_i| <= limit_i.
template <class T, int Brakes>
struct torque_box {
  vector<T, Brakes> lower;  ///< [N m]
  vector<T, Brakes> upper;  ///< [N m]
};

/// Torque box for signs s (-1, 0 or 1; 0 allows both directions) and limits [N m], which may be infinite.
template <class T, int Brakes>
torque_box<T, Brakes> torques_within(const vector<T, Brakes>& s, const vector<T, Brakes>& limit) {
  const lanes<T, Brakes> sign(s), most(limit);
  return {select(sign < T(0), T(0), -most), select(sign > T(0), T(0), most)};
}

/// Torque box of these brakes with signs s, from signs_within.
template <class B, class T, int Brakes>
torque_box<T, Brakes> torque_box_of(const vector<T, Brakes>& s, const B& brakes) {
  torque_box<T, Brakes> box = torques_within(s, passive_haptics::torque_limits_of<T, Brakes>(brakes));
  if constexpr (SwitchableBrakes<B, T, Brakes>)
    box = {box.lower.cwiseMax(brakes.torque_lower), box.upper.cwiseMin(brakes.torque_upper)};
  return box;
}

/// torque_box_of without limits: nonzero bounds become infinite.
template <class B, class T, int Brakes>
torque_box<T, Brakes> unbounded_torque_box_of(const vector<T, Brakes>& s, const B& brakes) {
  constexpr T infinity = std::numeric_limits<T>::infinity();
  if constexpr (SwitchableBrakes<B, T, Brakes>) {
    const auto box = passive_haptics::torque_box_of(s, brakes);
    return {(box.lower.array() < T(0)).select(vector<T, Brakes>::Constant(-infinity), T(0)),
            (box.upper.array() > T(0)).select(vector<T, Brakes>::Constant(infinity), T(0))};
  } else {
    return torques_within(s, vector<T, Brakes>(vector<T, Brakes>::Constant(infinity)));
  }
}

/// Nearest force and its torques.
template <class T, int D, int Brakes>
struct nearest_torque_result {
  vector<T, Brakes> torque;  ///< t [N m], exactly in the box; of least |t| for this force.
  vector<T, D> force;        ///< Fp = G t [N], to rounding of its terms.
};

namespace detail {

// Minimises the distance first, then the norm
template <class T, int D, int Brakes>
nearest_torque_result<T, D, Brakes> nearest_in_box(const matrix<T, D, Brakes>& G,
                                                   const torque_box<T, Brakes>& box, const vector<T, D>& Fd) {
  using solver = prioritised_least_squares<T, Brakes, (D > Brakes ? D : Brakes)>;
  solver t(box.lower, box.upper);
  typename solver::rows A = solver::rows::Zero();
  typename solver::targets b = solver::targets::Zero();
  A.template topRows<D>() = G;
  b.template head<D>() = Fd;
  t.minimise(A, b);
  t.minimise(solver::rows::Identity(), solver::targets::Zero());
  return {t.solution(), G * t.solution()};
}

// Directions without limits: t_i = way_i x_i with x_i >= 0, or any x_i. 0: no torque
template <class T, int Brakes>
struct open_ways {
  vector<T, Brakes> way;           // -1, 0 or 1
  lane_mask<T, Brakes> both_ways;  // x_i of any sign

  explicit open_ways(const vector<T, Brakes>& s)
      : way(copysign(T(1), -lanes(s))), both_ways(abs(lanes(s)) <= T(0)) {}
  explicit open_ways(const torque_box<T, Brakes>& box) {
    const auto up = lanes(box.upper) > T(0), down = lanes(box.lower) < T(0);
    way = select(up, T(1), select(down, T(-1), T(0)));
    both_ways = up & down;
  }
};

// A brake with both directions contributes two generators, + and - its column of V
template <class T, int D, int Brakes>
[[gnu::noinline]] nearest_torque_result<T, D, Brakes> nearest_both_ways(const matrix<T, D, Brakes>& V,
                                                                        const lane_mask<T, Brakes>& both_ways,
                                                                        const vector<T, D>& Fd) {
  matrix<T, D, 2 * Brakes> both;
  for (int i = 0; i < Brakes; ++i) {
    both.col(i) = V.col(i);
    both.col(Brakes + i) = T(both_ways[i] ? -1 : 0) * V.col(i);
  }
  const auto nearest = project_onto_generators(both, Fd);
  const vector<T, 2 * Brakes>& x = nearest.coefficients;
  return {x.template head<Brakes>() - x.template tail<Brakes>(), nearest.point};
}

// V = G diag(way), scaled so that its squares neither overflow nor underflow
template <class T, int D, int Brakes>
nearest_torque_result<T, D, Brakes> nearest_of_generators(const matrix<T, D, Brakes>& G,
                                                          open_ways<T, Brakes> ways, const vector<T, D>& Fd) {
  constexpr T max_square = sizeof(T) > sizeof(float) ? T(1e60) : T(1e15);
  vector<T, Brakes>& unit = ways.way;
  matrix<T, D, Brakes> V = G * unit.asDiagonal();
  if (const T square = V.squaredNorm(); !(square < max_square && square > T(1) / max_square)) {
    const T largest = V.cwiseAbs().maxCoeff();
    if (!all_finite(V) || largest == T(0)) return {vector<T, Brakes>::Zero(), vector<T, D>::Zero()};
    V /= largest;
    unit /= largest;
  }
  const auto [x, force] = [&]() -> nearest_torque_result<T, D, Brakes> {
    if (bits(ways.both_ways) != 0) return nearest_both_ways(V, ways.both_ways, Fd);
    const auto nearest = project_onto_generators(V, Fd);
    return {nearest.coefficients, nearest.point};
  }();
  return {unit.cwiseProduct(x), force};
}

}  // namespace detail

/// Force F = G t nearest to Fd of brakes with signs s (-1, 0 or 1; 0 allows any torque) without limits, s_i
/// t_i <= 0, with the torques of least |t|. They are unique and continuous. G (d x m) from force_generators,
/// Fd of moderate norm. F is 0 if G is not finite. Cost: core/linear/generated_cone.hpp for d <= 3, else
/// core/linear/prioritised_least_squares.hpp.
template <class T, int D, int Brakes>
nearest_torque_result<T, D, Brakes> nearest_torque(const matrix<T, D, Brakes>& G, const vector<T, Brakes>& s,
                                                   const vector<T, D>& Fd) {
  if constexpr (D <= 3) return detail::nearest_of_generators(G, detail::open_ways<T, Brakes>(s), Fd);
  else {
    const vector<T, Brakes> unlimited = vector<T, Brakes>::Constant(std::numeric_limits<T>::infinity());
    return detail::nearest_in_box(G, torques_within(s, unlimited), Fd);
  }
}

/// Force G t nearest to Fd over torques t in a box; the cone if the bounds are 0 and infinite. Cost:
/// core/linear/prioritised_least_squares.hpp, two levels.
template <class T, int D, int Brakes>
nearest_torque_result<T, D, Brakes> nearest_torque(const matrix<T, D, Brakes>& G,
                                                   const torque_box<T, Brakes>& box, const vector<T, D>& Fd) {
  if constexpr (D <= 3) {
    // t + t = t if t is 0 or infinite
    const lanes<T, Brakes> down = abs(lanes(box.lower)), up = abs(lanes(box.upper));
    if (bits((down + down <= down) & (up + up <= up)) == detail::all_columns<Brakes>)
      return detail::nearest_of_generators(G, detail::open_ways<T, Brakes>(box), Fd);
  }
  return detail::nearest_in_box(G, box, Fd);
}

/// Nearest torque, by signs or box, for a diagonal G.
template <class T, int D, class Within>
nearest_torque_result<T, D, D> nearest_torque(const diagonal_matrix<T, D>& G, const Within& signs_or_box,
                                              const vector<T, D>& Fd) {
  return nearest_torque(matrix<T, D, D>(G), signs_or_box, Fd);
}

}  // namespace passive_haptics
