/// @file
/// The figures of W points at once, for planar devices with two brakes on two joints: design_figures with
/// masks in place of branches, by the formulas of displayable() and sink_slope() for n = m = d.
#pragma once

#include <passive_haptics/control/batch/packable.hpp>
#include <passive_haptics/core/flatten.hpp>
#include <passive_haptics/core/scalar/pack_sine_cosine.hpp>
#include <passive_haptics/design/map/design_figures.hpp>

namespace passive_haptics::detail {

// Figures of W points, and at which of them they hold: the others need branches.
template <class T>
struct packed_figures {
  truth_of<T> are_valid;
  choice_of<T, display_class> display;
  T cosine, drag, strongest, sink_slope, isotropy;
};

// Singular values of a 2 x 2 matrix are (p + q) / 2 and |p - q| / 2, p and q the lengths of its two parts
// that turn and mirror. Their ratio, without cancellation where it is 1
template <class T>
T isotropy_of(const matrix<T, 2, 2>& E, const T& determinant)
  requires(!std::same_as<T, number_of<T>>)
{
  const T a = E(0, 0) + E(1, 1), b = E(1, 0) - E(0, 1), c = E(0, 0) - E(1, 1), d = E(1, 0) + E(0, 1);
  const lanes<T, 1> p = sqrt(lanes<T, 1>(a * a + b * b)), q = sqrt(lanes<T, 1>(c * c + d * d));
  const T sum = p[0] + q[0];
  return T(4) * abs(determinant) / (sum * sum);
}

// x / |x|
template <class T>
vector<T, 2> unit_of(const vector<T, 2>& x, const T& square) {
  const T length = sqrt(lanes<T, 1>(square))[0];
  return {x[0] / length, x[1] / length};
}

// q, direction and normal of W points. at_rest: the torques of brakes and motors at rest.
template <class M, class T, class Evaluator>
PASSIVE_HAPTICS_PART packed_figures<T> packed_figures_at(const M& mechanism, const Evaluator& brake_jacobian,
                                                         const vector<T, 2>& q, const vector<T, 2>& direction,
                                                         const vector<T, 2>& normal,
                                                         const torque_box<number_of<T>, 2>& at_rest,
                                                         const vector<number_of<T>, 2>& motor_limit,
                                                         number_of<T> push) {
  using number = number_of<T>;
  constexpr number tolerance = rounding_tolerance<number>(4), longest = 1e100, least_isotropy = 1e-6;
  const matrix<T, 2, 2> E(brake_jacobian(mechanism_pose<M, T>(mechanism, q)));
  const T determinant = E(0, 0) * E(1, 1) - E(0, 1) * E(1, 0);
  packed_figures<T> found;
  found.isotropy = isotropy_of(E, determinant);

  // Direction and normal of ordinary length, a regular pose
  const T vv = direction[0] * direction[0] + direction[1] * direction[1];
  const T nn = normal[0] * normal[0] + normal[1] * normal[1];
  const auto is_ordinary = [&](const T& square) {
    return (square >= T(1 / longest)) & (square <= T(longest));
  };
  const T limit(max_joint_position<number>);
  found.are_valid = (abs(q[0]) <= limit) & (abs(q[1]) <= limit) & is_ordinary(vv) & is_ordinary(nn) &
                    (found.isotropy > T(least_isotropy));

  // G = E^-T, w = G^T v, and signs that are 0 where a rate is of rounding size
  const matrix<T, 2, 2> G = matrix_of<2, 2>(E(1, 1) / determinant, -E(1, 0) / determinant,
                                            -E(0, 1) / determinant, E(0, 0) / determinant);
  const vector<T, 2> v = unit_of(direction, vv), n = unit_of(normal, nn);
  const vector<T, 2> w = transposed_times(G, v), b = transposed_times(G, n);
  using each = lanes<T, 2>;
  const each speed = abs(each(w)), ex = abs(row(E, 0)), ey = abs(row(E, 1)), gx = row(G, 0), gy = row(G, 1);
  const T tx = sum(ex * speed), ty = sum(ey * speed);
  const T terms = T(1) + sqrt(lanes<T, 1>(tx * tx + ty * ty))[0];
  const each rounding = sqrt(gx * gx + gy * gy) * (T(tolerance) * terms);
  const vector<T, 2> s = select(speed > rounding, sgn(each(w)), T(0));

  half_space_start start;
  const auto Fc = approximate(E, s, n, number(0), start);
  const T outward = n[0] * v[0] + n[1] * v[1];
  const vector<T, 2> tangential(v[0] - outward * n[0], v[1] - outward * n[1]);
  const T tt = tangential[0] * tangential[0] + tangential[1] * tangential[1];
  const auto moves_along = tt > T(rounding_tolerance<number>(2) * rounding_tolerance<number>(2));
  const vector<T, 2> unit = unit_of(tangential, tt);
  const vector<T, 2> along(select(moves_along, unit[0], T(0)), select(moves_along, unit[1], T(0)));

  const vector<T, 2> out = without_rounding(b);
  const each upper = select(each(s) > T(0), each(motor_limit), each(at_rest.upper));
  const each lower = select(each(s) < T(0), -each(motor_limit), each(at_rest.lower));
  const each bound = select(each(out) > T(0), upper, lower);
  const each resisted = select(abs(each(out)) > T(0), each(out) * bound, T(0));
  const auto is_made = (Fc.display == display_class::exact) | (Fc.display == display_class::approximate);

  found.display = Fc.display;
  found.cosine = Fc.cosine();
  found.drag = select(is_made, T(0) - (along[0] * Fc.force[0] + along[1] * Fc.force[1]),
                      T(std::numeric_limits<number>::quiet_NaN()));
  found.strongest = sum(resisted);
  if ((motor_limit.array() == number(0)).all()) found.strongest = select(is_made, found.strongest, T(0));
  const vector<T, 2> a = transposed_times(G, along);
  found.sink_slope = least_sink_slope(a, b, at_rest, motor_limit, T(push));
  return found;
}

}  // namespace passive_haptics::detail
