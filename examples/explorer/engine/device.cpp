#include "device.hpp"

#include "pose.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace explorer {
namespace {

void add(std::vector<double>& points, const place& x) { points.insert(points.end(), x.data(), x.data() + 3); }

// Forces within the torque limits, each brake from lower to upper [N m].
struct producible_forces {
  std::array<place, runtime::max_joints> of_brake;  // [N per N m]
  std::array<double, runtime::max_joints> lower{}, upper{};
  std::size_t count;

  // The force that goes farthest in a direction.
  place farthest(const place& direction) const {
    place F = place::Zero();
    for (std::size_t i = 0; i < count; ++i) {
      const double gain = of_brake[i].dot(direction);
      F += (gain > 0 ? upper[i] : gain < 0 ? lower[i] : 0.0) * of_brake[i];
    }
    return F;
  }
};

place direction_at(double angle, double height = 0) {
  const double radius = std::cos(height);
  return {radius * std::cos(angle), radius * std::sin(angle), std::sin(height)};
}

constexpr int directions = 180;  // of an outline
double angle_of(double k) { return 2 * std::numbers::pi * k / directions; }

// The closed outline in the plane.
std::vector<double> outline_in_plane(const producible_forces& set) {
  std::vector<double> points;
  for (int k = 0; k <= directions; ++k) add(points, set.farthest(direction_at(angle_of(k))));
  return points;
}

// The surface in space as triangles.
std::vector<double> outline_in_space(const producible_forces& set) {
  constexpr int slices = 32, stacks = 16;
  const auto on = [&](int i, int j) {
    return set.farthest(
        direction_at(2 * std::numbers::pi * i / slices, std::numbers::pi * (0.5 - double(j) / stacks)));
  };
  std::vector<double> points;
  for (int i = 0; i < slices; ++i)
    for (int j = 0; j < stacks; ++j) {
      const place a = on(i, j), b = on(i + 1, j), c = on(i + 1, j + 1), e = on(i, j + 1);
      for (const place& x : {a, b, c, a, c, e}) add(points, x);
    }
  return points;
}

// Forces that can be displayed exactly in each direction of the plane, of a device with self-motion, on which
// a brake makes no force by itself. The sides of the area are found by bisection, as the nearest force to one
// outside is there.
std::vector<double> outline_with_self_motion(const device_parts& of) {
  constexpr int bisections = 30;
  const state_settings& s = of.settings.state;
  const brake_numbers brakes = of.settings.brakes.numbers();
  const place v = of.velocity(s.q, s.qd);
  const auto at = [&](double k) {
    const place u = direction_at(angle_of(k));
    const auto found = of.kind->displayable(s.q, v, u, brakes);
    const bool is_exact = found.display == ph::display_class::exact;
    const double force = found.max_approximated_force;
    return place((found.is_known && is_exact && std::isfinite(force) ? force : 0.0) * u);
  };
  std::vector<double> points;
  bool ends = false;
  for (int k = 0; k <= directions; ++k) {
    const place F = at(k);
    const bool begins = F.norm() > 0;
    if (k > 0 && begins != ends) {
      double inside = begins ? k : k - 1, outside = begins ? k - 1 : k;
      for (int i = 0; i < bisections; ++i) {
        const double middle = (inside + outside) / 2;
        (at(middle).norm() > 0 ? inside : outside) = middle;
      }
      add(points, at(inside));
    }
    add(points, F);
    ends = begins;
  }
  return points;
}

}  // namespace

device::device(const configuration& c) : parts_(c), values_(pose_table(c)) { write_state(); }

void device::set(const settings& changed) {
  configuration next = parts().settings;
  next.take(changed);
  parts_ = device_parts(next);
  write_state();
}

settings device::changed() {
  configuration now = parts().settings, usual = now.defaults();
  settings all;
  all.set("mechanism", now.about->id);
  all.set("law", now.law_name());
  const field_list fields = now.fields(), defaults = usual.fields();
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const std::string text = text_of(fields[k]), &name = fields[k].name;
    if (name == "q" || name == "scene" || text != text_of(defaults[k])) all.set(name, text);
  }
  return all;
}

void device::write_state() {
  const state_settings& s = parts_.settings.state;
  state_.assign(std::size_t(2 * parts_.n() + 6), 0.0);
  auto at = std::copy(s.qd.begin(), s.qd.end(), std::copy(s.q.begin(), s.q.end(), state_.begin()));
  std::copy(s.Fh.begin(), s.Fh.end(), at);
  std::copy(s.Fd.begin(), s.Fd.end(), at + 3);
}

const device_parts& device::parts() {
  state_settings& s = parts_.settings.state;
  const double* at = state_.data();
  for (auto* joints : {&s.q, &s.qd}) {
    std::copy_n(at, joints->size(), joints->begin());
    at += joints->size();
  }
  for (auto* force : {&s.Fh, &s.Fd}) {
    std::copy_n(at, force->size(), force->begin());
    at += 3;
  }
  return parts_;
}

void device::set_joints(const joint_numbers& q) { std::copy_n(q.data(), q.size(), state_.begin()); }

bool device::reach(const place& x) {
  const auto found = parts().inverse(x, parts_.settings.state.q);
  if (!std::all_of(found.q.data(), found.q.data() + found.q.count,
                   [](double y) { return std::isfinite(y); }) ||
      !parts_.position(found.q).allFinite())
    return false;
  set_joints(found.q);
  return found.outcome == ph::status::ok;
}

void device::move(const place& v) {
  const joint_numbers qd = parts().kind->rates_for(parts_.settings.state.q, v);
  std::copy_n(qd.data(), qd.size(), state_.begin() + parts_.n());
}

void device::evaluate() { explorer::evaluate(values_, parts()); }

std::vector<double> device::draw() {
  const configuration& c = parts().settings;
  drawing made;
  c.about->draw({*parts_.mechanism, c.mechanism, c.state.q.data(), parts_.position(c.state.q)}, made);
  return made.numbers();
}

std::vector<double> device::bounds() {
  const double r = parts_.settings.about->reach(parts_.settings.mechanism), z = parts_.d() == 2 ? 0 : r;
  return {-r, -r, -z, r, r, z};
}

std::vector<double> device::outline(int region) {
  const device_parts& of = parts();
  const int m = of.m();
  if (of.n() > of.d()) return region == -1 ? outline_with_self_motion(of) : std::vector<double>();
  const state_settings& s = of.settings.state;
  const pose_brakes brakes = of.kind->brakes_at(s.q, s.qd, place_of(s.Fh), of.settings.brakes.numbers());
  if (!brakes.has_forces) return {};
  producible_forces set{brakes.force, {}, {}, std::size_t(m)};
  for (int i = 0; i < m; ++i) {
    const auto k = std::size_t(i);
    if (!of.settings.brakes.is_present(i)) continue;
    // Regions count from 0 as in passive_fme.hpp: (+,+), (+,-), (-,+), (-,-)
    const double sign = region < 0 ? -brakes.signs[k] : (region >> (m - 1 - i) & 1) != 0 ? -1 : 1;
    if (sign >= 0) set.upper[k] = of.settings.brakes.torque_limit[k];
    if (sign <= 0) set.lower[k] = -of.settings.brakes.torque_limit[k];
  }
  return of.d() == 2 ? outline_in_plane(set) : outline_in_space(set);
}

std::vector<double> device::locus(int brake, double length) {
  const device_parts& of = parts();
  std::vector<double> points;
  if (of.n() != 2) return points;
  // Joint rates at which the brake is at rest and the handle moves with 1 m/s
  const auto held_rates = [&](const ph::vector<double, 2>& q) {
    const numbers at(q.data(), 2);
    const auto rate = [&](double a, double b) {
      const double qd[] = {a, b};
      return of.mechanism->brake_rates(at, qd)[std::size_t(brake)];
    };
    const ph::vector<double, 2> qd(-rate(0, 1), rate(1, 0));
    return ph::vector<double, 2>(qd / of.velocity(at, {qd.data(), 2}).norm());
  };
  constexpr int steps = 32;  // to each side
  for (int k = -steps; k <= steps; ++k) {
    ph::vector<double, 2> q(of.settings.state.q.data());
    for (int i = 0; i < std::abs(k); ++i) {  // by the midpoint rule
      const double way = std::copysign(length / steps, k);
      q += way * held_rates(ph::vector<double, 2>(q + way / 2 * held_rates(q)));
    }
    const place x = of.position({q.data(), 2});
    if (x.allFinite()) add(points, x);
  }
  return points;
}

device make_device(const settings& given) {
  const std::string* id = given.find("mechanism");
  const std::string name = id == nullptr ? "" : *id;
  for (const page_mechanism& about : mechanisms()) {
    if (name != about.id) continue;
    configuration c(about);
    c.take(given);
    return device(c);
  }
  refuse("mechanism", name, names_of(mechanisms(), [](const auto& x) { return x.id; }));
}

}  // namespace explorer
