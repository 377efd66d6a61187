/// @file
/// The values of a pose: motion, forces, brakes and decision, each under the name that exports.hpp lists.
#pragma once

#include "configuration.hpp"
#include "value_table.hpp"

#include <passive_haptics/brake/at_rest/settled_rates.hpp>
#include <passive_haptics/brake/force_generators.hpp>
#include <passive_haptics/brake/passive_fme.hpp>
#include <passive_haptics/brake/signs.hpp>
#include <passive_haptics/design/displayable.hpp>
#include <passive_haptics/mechanism/dynamically_consistent_inverse.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace explorer {

/// Names of the classes, in the order of the library's enumerations.
inline std::vector<std::string> power_words() {
  return {"no force desired", "active", "passive I", "passive II"};
}
/// How a force is displayed.
inline std::vector<std::string> display_words() {
  return {"not displayed", "approximate", "exact", "no force desired"};
}
/// The number of the word for how a step displays its force.
template <class Result>
int display_number(const Result& r) {
  const bool is_desired = r.outcome != ph::status::ok || r.power != ph::power_class::none;
  return is_desired ? int(r.display) : int(ph::display_class::exact) + 1;
}
/// What a brake does.
enum class brake_doing { released, slips, holds, absent };
/// Its names.
inline std::vector<std::string> brake_words() { return {"released", "slips", "holds", "no brake"}; }
/// The status in words.
inline std::vector<std::string> status_words() {
  std::vector<std::string> all;
  for (int k = 0; k <= int(ph::status::time_not_rising); ++k) all.emplace_back(to_string(ph::status(k)));
  return all;
}

/// What brake i does at its rate [rad/s] with a capacity [N m].
template <class E>
brake_doing doing_of(const configuration<E>& c, int i, double rate, double capacity) {
  if (!c.is_present(i)) return brake_doing::absent;
  if (!(capacity > 0)) return brake_doing::released;
  return ph::slips(rate, double(c.brakes.rate_dead_band[i])) ? brake_doing::slips : brake_doing::holds;
}

/// The table of E's values and what fills it.
template <class E>
class pose_values {
  using C = configuration<E>;
  using M = typename E::mechanism;
  static constexpr int n = C::n, d = C::d, m = C::m;

 public:
  pose_values() {
    const auto vector_of = [&](const char* id, const char* label, const char* symbol, const char* equation,
                               const char* unit, const char* group) {
      return table_.add({id, label, symbol, equation, unit, group, 3, 3});
    };
    const auto number = [&](const char* id, const char* label, const char* symbol, const char* equation,
                            const char* unit, const char* group, std::vector<std::string> words = {}) {
      return table_.add({id, label, symbol, equation, unit, group, 1, 1, std::move(words)});
    };
    const std::string torque = E::slides ? "N" : "N m", rate = E::slides ? "m/s" : "rad/s";
    const auto of_brakes = [&](const char* id, const char* label, const char* symbol, const char* equation,
                               const std::string& unit, std::vector<std::string> words = {}) {
      return table_.add({id, label, symbol, equation, unit, "brakes", m, m, std::move(words)});
    };
    x_ = vector_of("x", "handle", "x", "", "m", "motion");
    v_ = vector_of("v", "velocity of the handle", "v", "", "m/s", "motion");
    J_ = table_.add({"J", "Jacobian", "J", "2", E::slides ? "1" : "m", "motion", 3 * n, n});
    w_ = of_brakes("w", "rates of the brakes", "θ̇", "", rate);
    signs_ = of_brakes("signs", "signs of the brakes' motion", "sgn θ̇", "3", "1");
    at_rest_ = of_brakes("at_rest", "at rest", "", "3", "1");
    E_ = table_.add(
        {"E", "map of brake rates to velocity", "E", "2", E::slides ? "1" : "m", "brakes", 3 * m, m});
    R_ = table_.add({"R", "reference forces", "R₊", "6", "N", "forces", 3 * m, 3});
    R_defined_ = number("R_defined", "reference forces are defined", "", "", "1", "forces");
    Fh_ = vector_of("Fh", "hand force", "Fₕ", "7", "N", "forces");
    Fd_ = vector_of("Fd", "desired force", "F_d", "", "N", "forces");
    depth_ = number("depth", "depth in the wall", "", "", "m", "forces");
    normal_ = vector_of("normal", "normal of the wall", "n", "", "1", "forces");
    Fp_ = vector_of("Fp", "nearest force, before the torque limits", "F_p", "", "N", "forces");
    Fc_ = vector_of("Fc", "control force, before α and the torque limits", "F_c", "7", "N", "forces");
    Fc_scaled_ =
        vector_of("Fc_scaled", "scaled control force, before the torque limits", "αF_c", "12", "N", "forces");
    displayed_ = vector_of("displayed", "displayed force, within the torque limits", "", "", "N", "forces");
    unscaled_ = vector_of("displayed_without_law", "displayed force without a law", "", "", "N", "forces");
    brake_force_ = vector_of("brake_force", "force of the predicted torques", "J⁻ᵀτ", "4", "N", "forces");
    Fr_ = vector_of("Fr", "resultant of hand and brakes", "F_r", "7", "N", "forces");
    gamma_ = number("gamma", "approximation angle", "γ", "", "rad", "decision");
    alpha_ = number("alpha", "scale factor", "α", "12", "1", "decision");
    coefficients_ =
        of_brakes("cone_coefficients", "torques that make F_c, before the torque limits", "τ", "4", torque);
    capacity_ = of_brakes("capacity", "commanded capacity", "|τ_c|", "3", torque);
    torque_ = of_brakes("torque", "predicted torque", "τ_c", "3", torque);
    limit_ = of_brakes("torque_limit", "torque limit", "", "", torque);
    share_ = of_brakes("torque_share", "share of the limit", "", "", "1");
    doing_ = of_brakes("brake_state", "state of the brake", "", "3", "", brake_words());
    power_ = number("power", "region of the desired force", "", "1", "", "decision", power_words());
    display_ = number("display", "how it is displayed, before the torque limits", "", "", "", "decision",
                      display_words());
    saturated_ = number("saturated", "a torque limit is reached", "", "", "", "decision", {"no", "yes"});
    region_ = number("region", "passive FME of the present signs", "", "", "1", "decision");
    max_force_ = number("max_force", "largest force along the desired one", "", "", "N", "decision");
    status_ = number("status", "status", "", "", "", "decision", status_words());
  }

  /// The table.
  value_table& table() { return table_; }

  /// Fills the table for a pose of `model`.
  void evaluate(const C& c, const M& model, const explorer_scene<d>& walls) {
    const ph::joint_vector<M>&q = c.top.q, &qd = c.top.qd;
    const ph::mechanism_pose<M> pose(model, q);
    const ph::task_vector<M> x = pose.position(), v = pose.velocity(qd);
    const ph::jacobian_matrix<M> J(pose.jacobian());
    const ph::brake_matrix<M> E_of_q(ph::brake_jacobian(model, q));
    const ph::brake_vector<M> w = ph::brake_rates(model, q, qd);
    const ph::brake_vector<M> th = ph::brake_torque(E_of_q, c.top.Fh);
    const ph::brake_vector<M> s = ph::brake_signs(w, th, c.brakes);
    put(x_, x), put(v_, v), put(Fh_, c.top.Fh);
    table_.put_rows(J_, ph::matrix<double, 3, n>::Zero(), n);
    table_.put_rows(J_, J, n);
    table_.put_rows(E_, ph::matrix<double, 3, m>::Zero(), m);
    table_.put_rows(E_, E_of_q, m);
    table_.put_column(w_, w, m);
    table_.put_column(signs_, s, m);
    for (int i = 0; i < m; ++i) table_.put(at_rest_ + i, ph::slips(w[i], c.brakes.rate_dead_band[i]) ? 0 : 1);
    put_reference_forces(pose);

    explorer_scene<d> scene = c.top.desired == desired_kind::given
                                  ? explorer_scene<d>(wall_or_force<d>::demanding(c.top.Fd, x), 0)
                                  : walls;
    const auto touched = scene.scene().touched_at(x);
    put(normal_, touched.empty() ? ph::task_vector<M>(ph::task_vector<M>::Zero()) : touched[0].normal);
    table_.put(depth_, touched.empty() ? 0.0 : touched[0].depth);

    const ph::device_state<M> state{0, q, qd, c.top.Fh};
    const auto without_law = c.control(model, law_kind::no_direct_control, scene),
               control = c.control(model, scene);
    const ph::step_result<M> whole = without_law->decide(state), r = control->decide(state);
    const ph::task_vector<M> Fc = whole.control_force;
    const ph::task_vector<M> Fc_scaled = r.alpha * Fc;
    const double cosine = whole.approximation_cosine;
    put(Fd_, whole.desired_force);
    put(Fp_, ph::task_vector<M>(cosine * cosine * Fc));
    put(Fc_, Fc);
    put(Fc_scaled_, Fc_scaled);
    put(displayed_, displayed_force(c, pose, *control, r));
    put(unscaled_, displayed_force(c, pose, *without_law, whole));
    table_.put(gamma_, whole.approximation_angle());
    table_.put(alpha_, r.alpha);
    table_.put_column(coefficients_, whole.cone_coefficients, m);
    table_.put_column(capacity_, r.capacity, m);
    table_.put_column(torque_, r.torque, m);
    table_.put_column(limit_, c.brakes.torque_limit, m);
    const ph::task_vector<M> felt = force_of(pose, r.torque);
    put(brake_force_, felt);
    put(Fr_,
        ph::task_vector<M>(c.top.Fh + felt));  // a brake that holds takes what the hand gives, not alpha Fc
    for (int i = 0; i < m; ++i) {
      const double limit = c.brakes.torque_limit[i];
      table_.put(share_ + i, limit > 0 ? r.capacity[i] / limit : 0);
      table_.put(doing_ + i, int(doing_of(c, i, w[i], r.capacity[i])));
    }
    table_.put(power_, int(r.power));
    table_.put(display_, display_number(r));
    table_.put(saturated_, r.saturated ? 1 : 0);
    table_.put(region_, region_of(s));
    table_.put(max_force_, max_force(c, model, q, v, whole.desired_force));
    table_.put(status_, int(r.outcome));
  }

 private:
  template <class Vector>
  void put(int offset, const Vector& x) {
    table_.put_column(offset, x, 3);
  }

  void put_reference_forces(const ph::mechanism_pose<M>& pose) {
    bool is_defined = false;
    table_.put_rows(R_, ph::matrix<double, m, 3>::Zero(), 3);
    if constexpr (n == d) {
      const ph::brake_matrix<M> G = ph::force_generators(pose);
      is_defined = G.allFinite();
      if (is_defined) table_.put_rows(R_, ph::transposed(G), 3);
    }
    table_.put(R_defined_, is_defined ? 1 : 0);
  }

  // The force at the handle that does what these torques do; 0 where there is none.
  static ph::task_vector<M> force_of(const ph::mechanism_pose<M>& pose, const ph::brake_vector<M>& t) {
    ph::task_vector<M> F;
    if constexpr (n == d) {
      F = ph::force_generators(pose) * t;
    } else {
      const ph::jacobian_matrix<M> J(pose.jacobian());
      const ph::dynamically_consistent_inverse<double, n, d> inverse(J, pose.mass_matrix());
      F = inverse.forces(ph::joint_vector<M>(pose.transposed_transmission() * t));
    }
    return F.allFinite() ? F : ph::task_vector<M>(ph::task_vector<M>::Zero());
  }

  // The force at the handle that the commanded torques make, within the limits; for n > d once the
  // self-motion has settled. A brake that holds gives less of it if the hand pushes less.
  static ph::task_vector<M> displayed_force(const C& c, const ph::mechanism_pose<M>& pose,
                                            const any_control<M>& control, const ph::step_result<M>& r) {
    ph::brake_vector<M> t;
    for (int i = 0; i < m; ++i) t[i] = std::copysign(r.capacity[i], r.cone_coefficients[i]);
    if (!control.cuts_each_brake()) {
      double share = r.alpha;  // of Fc, which is also defined at a singular pose
      for (int i = 0; r.saturated && i < m; ++i)
        if (t[i] != 0) share = std::min(share, t[i] / r.cone_coefficients[i]);
      return share * r.control_force;
    }
    if constexpr (ph::Settles<M>) return settled_force(c, pose, t);
    else return r.saturated ? force_of(pose, t) : r.control_force;
  }

  // The force of these torques once those brakes are at rest that leave the others the least power.
  static ph::task_vector<M> settled_force(const C& c, const ph::mechanism_pose<M>& pose,
                                          const ph::brake_vector<M>& torque) {
    const ph::settled_rates<M> rates(pose, ph::settled_rates<M>::default_share,
                                     ph::brakes_without_torque<double, m>(c.switchable()));
    ph::task_vector<M> F = ph::task_vector<M>::Zero();
    double least = std::numeric_limits<double>::infinity();
    rates.for_each([&](ph::brake_set, const auto& W) {
      const ph::brake_vector<M> w = W * pose.velocity(c.top.qd);
      const double power = w.cwiseAbs().dot(torque.cwiseAbs());
      if (!(power < least)) return false;
      least = power;
      ph::brake_vector<M> t = torque;
      for (int i = 0; i < m; ++i)
        if (w[i] != 0) t[i] = -std::copysign(t[i], w[i]);
      F = ph::transposed(W) * t;
      return false;
    });
    return F;
  }

  static int region_of(const ph::brake_vector<M>& s) {
    if ((s.array() == 0).any()) return -1;
    const auto signs = ph::producible_signs<double, m>(s);
    const auto regions = ph::passive_fme_regions<m>();
    for (std::size_t k = 0; k < regions.size(); ++k)
      if (regions[k] == signs) return static_cast<int>(k);
    return -1;
  }

  static double max_force(const C& c, const M& model, const ph::joint_vector<M>& q,
                          const ph::task_vector<M>& v, const ph::task_vector<M>& Fd) {
    if (!(Fd.norm() > 0)) return 0;
    const auto found = ph::displayable(model, q, v, Fd, ph::hybrid_brakes<M>(c.switchable()));
    return found.outcome == ph::status::ok ? found.max_force : 0;
  }

  value_table table_;
  int x_, v_, J_, w_, signs_, at_rest_, E_, R_, R_defined_, Fh_, Fd_, depth_, normal_, Fp_, Fc_, Fc_scaled_,
      displayed_, unscaled_, brake_force_, Fr_, gamma_, alpha_, coefficients_, capacity_, torque_, limit_,
      share_, doing_, power_, display_, saturated_, region_, max_force_, status_;
};

}  // namespace explorer
