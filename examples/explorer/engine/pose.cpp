#include "pose.hpp"

#include <passive_haptics/brake/passive_fme.hpp>
#include <passive_haptics/brake/signs.hpp>

#include <cmath>

namespace explorer {
namespace {

// The force at the handle that the commanded torques make, within the limits; for n > d once the
// self-motion has settled. A brake that holds gives less of it if the hand pushes less.
place displayed_force(const device_parts& of, bool cuts_each_brake, const runtime::cycle_record& r) {
  joint_numbers t = r.capacity;
  for (std::size_t i = 0; i < t.size(); ++i) t.values[i] = std::copysign(t[i], r.cone_coefficients[i]);
  const place Fc = place_of(r.control_force);
  const state_settings& s = of.settings.state;
  if (cuts_each_brake) {
    if (of.n() > of.d()) return of.kind->settled_force(s.q, s.qd, t, of.settings.brakes.numbers());
    return r.saturated ? of.kind->force_of(s.q, t) : Fc;
  }
  double share = r.alpha;  // of Fc, which is also defined at a singular pose
  for (std::size_t i = 0; r.saturated && i < t.size(); ++i)
    if (t[i] != 0) share = std::min(share, t[i] / r.cone_coefficients[i]);
  return share * Fc;
}

// The number of the passive FME of these signs; -1 if a brake is at rest.
int region_of(const joint_numbers& signs) {
  int region = 0;
  for (std::size_t i = 0; i < signs.size(); ++i) {
    if (signs[i] == 0) return -1;
    region = 2 * region + (signs[i] > 0 ? 1 : 0);  // a brake's torque opposes its motion
  }
  return region;
}

}  // namespace

std::vector<std::string> power_words() { return {"no force desired", "active", "passive I", "passive II"}; }
std::vector<std::string> display_words() {
  return {"not displayed", "approximate", "exact", "no force desired"};
}
std::vector<std::string> brake_words() { return {"released", "slips", "holds", "no brake"}; }
std::vector<std::string> status_words() {
  std::vector<std::string> all;
  for (int k = 0; k <= int(ph::status::time_not_rising); ++k) all.emplace_back(to_string(ph::status(k)));
  return all;
}
int display_number(const runtime::cycle_record& r) {
  const bool is_desired = r.outcome != ph::status::ok || r.power != ph::power_class::none;
  return is_desired ? int(r.display) : int(ph::display_class::exact) + 1;
}
void put_brake_states(value_table& table, const configuration& c, numbers rates, numbers capacity) {
  double* states = table["brake_state"];
  for (std::size_t i = 0; i < rates.size(); ++i)
    states[i] = !c.brakes.is_present(int(i))                      ? 3
                : !(capacity[i] > 0)                              ? 0
                : ph::slips(rates[i], c.brakes.rate_dead_band[i]) ? 1
                                                                  : 2;
}

value_table pose_table(const configuration& c) {
  const auto [n, d, m] = c.sizes;
  const bool slides = c.about->slides;
  const std::string torque = slides ? "N" : "N m", rate = slides ? "m/s" : "rad/s",
                    length = slides ? "1" : "m";
  const char *motion = "motion", *forces = "forces", *brakes = "brakes", *decision = "decision";
  return value_table({
      {"x", "handle", "x", "", "m", motion, 3, 3},
      {"v", "velocity of the handle", "v", "", "m/s", motion, 3, 3},
      {"J", "Jacobian", "J", "2", length, motion, 3 * n, n},
      {"w", "rates of the brakes", "θ̇", "", rate, brakes, m, m},
      {"signs", "signs of the brakes' motion", "sgn θ̇", "3", "1", brakes, m, m},
      {"at_rest", "at rest", "", "3", "1", brakes, m, m},
      {"E", "map of brake rates to velocity", "E", "2", length, brakes, 3 * m, m},
      {"R", "reference forces", "R₊", "6", "N", forces, 3 * m, 3},
      {"R_defined", "reference forces are defined", "", "", "1", forces},
      {"Fh", "hand force", "Fₕ", "7", "N", forces, 3, 3},
      {"Fd", "desired force", "F_d", "", "N", forces, 3, 3},
      {"depth", "depth in the wall", "", "", "m", forces},
      {"normal", "normal of the wall", "n", "", "1", forces, 3, 3},
      {"Fp", "nearest force, before the torque limits", "F_p", "", "N", forces, 3, 3},
      {"Fc", "control force, before α and the torque limits", "F_c", "7", "N", forces, 3, 3},
      {"Fc_scaled", "scaled control force, before the torque limits", "αF_c", "12", "N", forces, 3, 3},
      {"displayed", "displayed force, within the torque limits", "", "", "N", forces, 3, 3},
      {"displayed_without_law", "displayed force without a law", "", "", "N", forces, 3, 3},
      {"brake_force", "force of the predicted torques", "J⁻ᵀτ", "4", "N", forces, 3, 3},
      {"Fr", "resultant of hand and brakes", "F_r", "7", "N", forces, 3, 3},
      {"gamma", "approximation angle", "γ", "", "rad", decision},
      {"alpha", "scale factor", "α", "12", "1", decision},
      {"cone_coefficients", "torques that make F_c, before the torque limits", "τ", "4", torque, brakes, m,
       m},
      {"capacity", "commanded capacity", "|τ_c|", "3", torque, brakes, m, m},
      {"torque", "predicted torque", "τ_c", "3", torque, brakes, m, m},
      {"torque_limit", "torque limit", "", "", torque, brakes, m, m},
      {"torque_share", "share of the limit", "", "", "1", brakes, m, m},
      {"brake_state", "state of the brake", "", "3", "", brakes, m, m, brake_words()},
      {"power", "region of the desired force", "", "1", "", decision, 1, 1, power_words()},
      {"display", "how it is displayed, before the torque limits", "", "", "", decision, 1, 1,
       display_words()},
      {"saturated", "a torque limit is reached", "", "", "", decision, 1, 1, {"no", "yes"}},
      {"region", "passive FME of the present signs", "", "", "1", decision},
      {"max_force", "largest force along the desired one", "", "", "N", decision},
      {"status", "status", "", "", "", decision, 1, 1, status_words()},
  });
}

void evaluate(value_table& table, const device_parts& of) {
  const configuration& c = of.settings;
  const state_settings& s = c.state;
  const place x = of.position(s.q), v = of.velocity(s.q, s.qd), Fh = place_of(s.Fh);
  const brake_numbers limits = c.brakes.numbers();
  const pose_brakes brakes = of.kind->brakes_at(s.q, s.qd, Fh, limits);
  const auto J = of.jacobian(s.q);
  const std::size_t n = std::size_t(of.n()), m = std::size_t(of.m());
  table.put("x", x);
  table.put("v", v);
  table.put("Fh", Fh);
  for (int i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < n; ++j) table["J"][std::size_t(i) * n + j] = J[j][i];
    for (std::size_t k = 0; k < m; ++k) table["E"][std::size_t(i) * m + k] = brakes.E[k][i];
  }
  for (std::size_t k = 0; k < m; ++k) {
    std::copy_n(brakes.force[k].data(), 3, table["R"] + 3 * k);
    table["at_rest"][k] = ph::slips(brakes.rates[k], limits.rate_dead_band[k]) ? 0 : 1;
  }
  table.put("w", brakes.rates);
  table.put("signs", brakes.signs);
  table.put("R_defined", brakes.has_forces ? 1 : 0);

  scene_source scene = c.scene_of(of.wall);
  place normal = place::Zero();
  double depth = std::max(0.0, -of.wall.distance(x));
  if (depth > 0) normal = of.wall.gradient(x);
  if (s.desired == desired_kind::given) {
    scene.is_given = true;
    scene.Fd = place_of(s.Fd);
    scene.at = x;
    const double size = scene.Fd.norm();
    normal = size > 0 ? ph::direction_of(scene.Fd) : scene.Fd;
    depth = size > 0 ? scene_source::given_depth : 0;
  }
  table.put("normal", normal);
  table.put("depth", depth);

  const page_controller without_law = c.controller_without_law(*of.kind, scene),
                        control = c.controller(*of.kind, scene);
  const runtime::state_view state{0, s.q, s.qd, s.Fh};
  const runtime::cycle_record whole = without_law.decide(state), r = control.decide(state);
  const place Fd = place_of(whole.desired_force), Fc = place_of(whole.control_force);
  const double cosine = whole.approximation_cosine;
  const place felt = of.kind->force_of(s.q, r.torque);
  table.put("Fd", Fd);
  table.put("Fp", place(cosine * cosine * Fc));
  table.put("Fc", Fc);
  table.put("Fc_scaled", place(r.alpha * Fc));
  table.put("displayed", displayed_force(of, control.cuts_each_brake, r));
  table.put("displayed_without_law", displayed_force(of, without_law.cuts_each_brake, whole));
  table.put("brake_force", felt);
  table.put("Fr", place(Fh + felt));  // a brake that holds takes what the hand gives, not alpha Fc
  table.put("gamma", whole.approximation_angle());
  table.put("alpha", r.alpha);
  table.put("cone_coefficients", whole.cone_coefficients);
  table.put("capacity", r.capacity);
  table.put("torque", r.torque);
  table.put("torque_limit", limits.torque_limit);
  for (std::size_t k = 0; k < m; ++k)
    table["torque_share"][k] = limits.torque_limit[k] > 0 ? r.capacity[k] / limits.torque_limit[k] : 0;
  put_brake_states(table, c, brakes.rates, r.capacity);
  table.put("power", int(r.power));
  table.put("display", display_number(r));
  table.put("saturated", r.saturated ? 1 : 0);
  table.put("region", region_of(brakes.signs));
  table.put("max_force", Fd.norm() > 0 ? of.kind->displayable(s.q, v, Fd, limits).max_force : 0);
  table.put("status", int(r.outcome));
}

}  // namespace explorer
