#include "mechanisms.hpp"

#include "chains.hpp"

#include <catalogue/laws.hpp>

#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>
#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

namespace explorer {
namespace {

constexpr double brake_share = 0.13;  // radius of a brake, of the longest length of a device [1]
const place out_of_plane(0, 0, 1);

place polar(double length, double angle) { return length * place(std::cos(angle), std::sin(angle), 0); }

// An arm over these points to the handle, with a joint at each, about z or these axes, and a brake on each
// joint unless the brakes are elsewhere.
void draw_arm(const drawn_pose& at, drawing& to, std::vector<place> points, double size,
              bool has_joint_brakes = true,
              const std::vector<place>& axes = {out_of_plane, out_of_plane, out_of_plane}) {
  const std::size_t n = points.size();
  points.push_back(at.handle);
  to.add(item_kind::ground, points[0], size);
  for (std::size_t i = 0; i < n; ++i) {
    to.add(item_kind::link, int(i), points[i], points[i + 1]);
    to.add_turning(item_kind::joint, int(i), points[i], axes[i]);
    if (has_joint_brakes) to.add_turning(item_kind::brake, int(i), points[i], axes[i], size, at.q[i]);
  }
  to.add(item_kind::handle, at.handle);
}

template <class P>
double reach_of_two_links(const P& p) {
  return p.length_1 + p.length_2;
}

using two_link = ph::two_link_parameters<double>;
void draw_two_link(const drawn_pose& at, drawing& to) {
  const auto& p = at.parameters.as<two_link>();
  draw_arm(at, to, {place::Zero(), polar(p.length_1, at.q[0])},
           brake_share * std::max(p.length_1, p.length_2));
}

// The two outer tangents of pulleys of radii r at a and s at b, in the plane.
void add_belt(drawing& to, int brake, const place& a, double r, const place& b, double s) {
  const place apart = b - a;
  const double distance = apart.norm();
  if (!(distance > std::abs(r - s))) return;
  const place u = apart / distance, left(-u[1], u[0], 0);
  const double sine = (r - s) / distance, cosine = std::sqrt(1 - sine * sine);
  for (const double side : {1.0, -1.0}) {
    const place out = sine * u + side * cosine * left;
    to.add(item_kind::belt, brake, a + r * out, b + s * out);
  }
}

using tendon_two_link = ph::tendon_two_link_parameters<double>;
void draw_tendon_two_link(const drawn_pose& at, drawing& to) {
  const auto& p = at.parameters.as<tendon_two_link>();
  const place shoulder = place::Zero(), elbow = polar(p.length_1, at.q[0]);
  const double size = brake_share * std::max(p.length_1, p.length_2);
  draw_arm(at, to, {shoulder, elbow}, size, false);
  // The larger pulley of the reduction has the drawn size: k2 is the ratio of the radii
  const double k2 = p.reduction_2, at_base = size * std::min(1.0, k2),
               at_elbow = size * std::min(1.0, 1 / k2);
  const auto turned = at.mechanism.brake_rates({at.q, 2}, {at.q, 2});  // by which the brakes' axes turned
  add_belt(to, 1, shoulder, at_base, elbow, at_elbow);
  to.add_turning(item_kind::pulley, 1, shoulder, out_of_plane, at_base, turned[1]);
  to.add_turning(item_kind::pulley, 1, elbow, out_of_plane, at_elbow, at.q[0] + at.q[1]);
  to.add_turning(item_kind::brake, 0, shoulder, out_of_plane, size, turned[0]);
  to.add_turning(item_kind::brake, 1, shoulder, out_of_plane, size / 2, turned[1]);
}

constexpr double rail = 0.15;  // half of each rail of an XY table, as it is drawn [m]
void draw_xy_table(const drawn_pose& at, drawing& to) {
  const double size = brake_share * rail;
  const place along_x(1, 0, 0), along_y(0, 1, 0), left(-rail, -rail, 0), right(rail, -rail, 0);
  const place carriage(at.q[0], -rail, 0), end(at.q[0], rail, 0);
  for (const place& x : {left, right}) to.add(item_kind::ground, x, size);
  to.add(item_kind::slide, 0, left, right);
  to.add(item_kind::slide, 1, carriage, end);
  to.add_turning(item_kind::carriage, 0, carriage, along_x, size);
  to.add_turning(item_kind::carriage, 1, at.handle, along_y, size);
  to.add_turning(item_kind::brake, 0, carriage, along_x, size, at.q[0]);
  to.add_turning(item_kind::brake, 1, at.handle, along_y, size, at.q[1]);
  to.add(item_kind::handle, at.handle);
}

template <int Brakes>
void draw_five_bar(const drawn_pose& at, drawing& to) {
  const auto& p = at.parameters.as<ph::five_bar_parameters<double, Brakes>>();
  const double size = brake_share * p.proximal_1, half = p.base_distance / 2;
  const place base[] = {place(-half, 0, 0), place(half, 0, 0)};
  const place elbow[] = {base[0] + polar(p.proximal_1, at.q[0]), base[1] + polar(p.proximal_2, at.q[1])};
  for (const place& x : base) to.add(item_kind::ground, x, size);
  for (int i = 0; i < 2; ++i) {
    to.add(item_kind::link, i, base[i], elbow[i]);
    to.add(item_kind::link, 2 + i, elbow[i], at.handle);
    to.add_turning(item_kind::joint, i, base[i], out_of_plane);
    to.add_turning(item_kind::joint, 2 + i, elbow[i], out_of_plane);
    to.add_turning(item_kind::brake, i, base[i], out_of_plane, size, at.q[i]);
  }
  if (Brakes == 4)  // on the difference and the sum of the base angles, next to the base
    for (const int side : {-1, 1})
      to.add_turning(item_kind::brake, side < 0 ? 2 : 3, place(side * (half + 3 * size), -3 * size, 0),
                     out_of_plane, size, at.q[0] + side * at.q[1]);
  to.add(item_kind::handle, at.handle);
}
template <class P>
double reach_of_five_bar(const P& p) {
  return p.proximal_1 + p.distal_1;
}

void draw_planar_3r(const drawn_pose& at, drawing& to) {
  const auto& p = at.parameters.as<planar_3r_parameters>();
  const place elbow = polar(p.length_1, at.q[0]), wrist = elbow + polar(p.length_2, at.q[0] + at.q[1]);
  draw_arm(at, to, {place::Zero(), elbow, wrist}, brake_share * p.reach() / 2);
}

using delta = ph::delta_parameters<double>;
void draw_delta(const drawn_pose& at, drawing& to) {
  const auto& p = at.parameters.as<delta>();
  const double size = brake_share * p.upper_arm;
  std::array<place, 3> out;
  for (int i = 0; i < 3; ++i) out[std::size_t(i)] = polar(1, 2 * std::numbers::pi * i / 3);
  for (int i = 0; i < 3; ++i) {
    const place &here = out[std::size_t(i)], &next = out[std::size_t((i + 1) % 3)];
    const place base = p.base_radius * here, aside = ph::cross(out_of_plane, here);
    const place elbow = base + p.upper_arm * (std::cos(at.q[i]) * here - std::sin(at.q[i]) * out_of_plane);
    const place end = at.handle + p.platform_radius * here;
    to.add(item_kind::ground, base, size);
    to.add(item_kind::link, i, base, elbow);
    for (const double side : {-size, size})  // both rods of the parallelogram
      to.add(item_kind::link, 3 + i, elbow + side * aside, end + side * aside);
    to.add(item_kind::platform, i, end, at.handle + p.platform_radius * next);
    to.add(item_kind::platform, 3 + i, base, p.base_radius * next);
    to.add_turning(item_kind::joint, i, base, aside);
    to.add_turning(item_kind::brake, i, base, aside, size, at.q[i]);
  }
  to.add(item_kind::handle, at.handle);
}

void draw_spatial_3r(const drawn_pose& at, drawing& to) {
  const auto& p = at.parameters.as<spatial_3r_parameters>();
  const place ahead = polar(1, at.q[0]), shoulder(0, 0, p.length_1), right(ahead[1], -ahead[0], 0);
  const place elbow = shoulder + p.length_2 * (std::cos(at.q[1]) * ahead + std::sin(at.q[1]) * out_of_plane);
  draw_arm(at, to, {place::Zero(), shoulder, elbow}, brake_share * p.reach() / 2, true,
           {out_of_plane, right, right});
}

struct page_catalogue {
  runtime::catalogue all;
  std::vector<page_mechanism> mechanisms;

  template <class M, class P>
  void add(const char* id, const char* label, const char* scene, std::vector<double> start,
           double (*reach)(const P&), void (*draw)(const drawn_pose&, drawing&), bool slides = false) {
    all.add_mechanism<M, P>(id);
    mechanisms.push_back({id, label, scene, std::move(start), slides,
                          [reach](const runtime::any_parameters& p) { return reach(p.as<P>()); }, draw});
  }

  page_catalogue() {
    // The two links begin with the handle at (0.1, 0.22) m, elbow left, the five-bars at (0.01, 0.098) m
    const std::vector<double> two_links = {1.7806893577270945, -1.2747394484060247},
                              five_bars = {2.239309785437203, 0.8093484082683855};
    constexpr const char *wall = "plane:0,0.225,0,-1",                                   // of section 5.2
        *slanted = "plane:0,0.05,0.5,-0.8660254037844386", *close = "plane:0,0.1,0,-1";  // by 30 deg, Fig. 5
    add<ph::tendon_two_link<double>, tendon_two_link>("tendon_two_link",
                                                      "The paper's device: two links and a tendon", wall,
                                                      two_links, reach_of_two_links, draw_tendon_two_link);
    add<ph::two_link<double>, two_link>("two_link", "Two links", wall, two_links, reach_of_two_links,
                                        draw_two_link);
    add<ph::xy_table<double>, ph::xy_table_parameters<double>>(
        "xy_table", "XY table", slanted, {0.02, 0.055}, [](const auto&) { return rail; }, draw_xy_table,
        true);
    add<ph::five_bar<double>, ph::five_bar_parameters<double>>(
        "five_bar", "Five-bar, two brakes", close, five_bars, reach_of_five_bar, draw_five_bar<2>);
    add<ph::five_bar<double, 4>, ph::five_bar_parameters<double, 4>>(
        "five_bar_4", "Five-bar, four brakes", close, five_bars, reach_of_five_bar, draw_five_bar<4>);
    add<planar_3r, planar_3r_parameters>(
        "planar_3r", "Three links in the plane, one more than needed", "plane:0,0.2,0,-1",
        {2.13, -1.12, -1.06}, [](const auto& p) { return p.reach(); }, draw_planar_3r);
    add<ph::delta<double>, delta>(
        "delta", "Delta", "plane:0,0,-0.15,0,0,1", {0.5, 0.62, 0.71},
        [](const auto& p) { return p.base_radius + p.upper_arm + p.forearm; }, draw_delta);
    add<spatial_3r, spatial_3r_parameters>(
        "spatial_3r", "An arm in space", "plane:0,0,0.05,0,0,1", {0.3, 0.3, -1.6},
        [](const auto& p) { return p.reach(); }, draw_spatial_3r);
    std::apply([&](const auto&... law) { all.add_laws(law...); }, example::laws);
  }
};

const page_catalogue& of_page() {
  static const page_catalogue all;
  return all;
}

}  // namespace

const std::vector<page_mechanism>& mechanisms() { return of_page().mechanisms; }
const runtime::catalogue& catalogue() { return of_page().all; }

}  // namespace explorer
