/// Figures of planar devices with two joints and two brakes, with the inverse of E in closed form.
#pragma once

#include <passive_haptics/core/flatten.hpp>
#include <passive_haptics/design/map/design_figures.hpp>

#include <cmath>
#include <concepts>
#include <optional>

namespace passive_haptics::detail {

// Devices of planar_figures; its bounds are chosen for double.
template <class M>
concept is_planar_with_two_brakes =
    std::same_as<typename M::scalar, double> && M::dof == 2 && M::task_dimension == 2 && M::brake_count == 2;

// Minimum by maximum singular value of E. They are (p + q) / 2 and |p - q| / 2, with the norms p and q of the
// rotating and mirroring parts of E. Their product is |det E|, which avoids cancellation at a ratio of 1.
inline double isotropy_of(const matrix<double, 2, 2>& E, double determinant) {
  const double p = vector<double, 2>(E(0, 0) + E(1, 1), E(1, 0) - E(0, 1)).norm();
  const double q = vector<double, 2>(E(0, 0) - E(1, 1), E(1, 0) + E(0, 1)).norm();
  return 4 * std::abs(determinant) / ((p + q) * (p + q));
}

// Figures of points of one device with brakes that all work both ways.
template <is_planar_with_two_brakes M>
class planar_figures {
 public:
  planar_figures(const M& mechanism, const hybrid_brakes<M>& brakes, double push)
      : mechanism_(mechanism),
        brake_jacobian_(mechanism),
        brakes_(brakes),
        at_rest_(passive_haptics::torque_box_of(brake_vector<M>(brake_vector<M>::Zero()), brakes)),
        push_(push) {}

  design_figures<double> operator()(const path_point<M>& at) const {
    const auto found = closed_form(at);
    return found ? *found : design_figures_at(mechanism_, at, brakes_, push_);
  }

 private:
  // Empty near singular poses and for extreme sizes, for which only the general form is accurate.
  PASSIVE_HAPTICS_FLATTEN std::optional<design_figures<double>> closed_form(const path_point<M>& at) const {
    constexpr double min_isotropy = 1e-6;
    const brake_matrix<M> E(brake_jacobian_(mechanism_pose<M>(mechanism_, at.q)));
    const double det = determinant(E), isotropy = isotropy_of(E, det);
    if (!(isotropy > min_isotropy) || !is_ordinary(at)) return {};

    const task_vector<M> v = at.direction.normalized(), n = at.normal.normalized();
    task_vector<M> along = v - n.dot(v) * n;
    const double length = along.norm();
    along *= length > rounding_tolerance<double>(2) ? 1 / length : 0;
    // W = E^-1: w = W v
    const auto W = matrix_of<2, 2>(E(1, 1) / det, -E(0, 1) / det, -E(1, 0) / det, E(0, 0) / det);
    const brake_vector<M> s = signs_in_motion(W, E, v), b = times(W, n);
    half_space_start start;
    const auto Fc = approximate(E, s, n, 0.0, start);

    design_figures<double> found;
    found.display = Fc.display;
    if (is_displayed(Fc.display)) {
      found.cosine = Fc.cosine();
      found.drag = 0 - along.dot(Fc.force);  // no -0
    }
    if (is_displayed(Fc.display) || brakes_.has_motors())
      found.max_force = max_resistance(passive_haptics::torque_box_of(s, brakes_), b);
    found.sink_slope = min_sink_slope(times(W, along), b, at_rest_, brakes_.motor_limit, push_);
    found.isotropy = isotropy;
    return found;
  }

  static bool is_ordinary(const path_point<M>& at) {
    constexpr double longest = 1e50, farthest = max_joint_position<double>;
    const auto is_usual = [](double length) { return length >= 1 / longest && length <= longest; };
    return std::abs(at.q[0]) <= farthest && std::abs(at.q[1]) <= farthest && is_usual(at.direction.norm()) &&
           is_usual(at.normal.norm());
  }

  const M& mechanism_;
  brake_jacobian_evaluator<M> brake_jacobian_;
  const hybrid_brakes<M>& brakes_;
  torque_box<double, 2> at_rest_;  // of brakes and motors [N m]
  double push_;
};

}  // namespace passive_haptics::detail
