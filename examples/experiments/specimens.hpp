// The list of shapes for the experiments on scenes and for the property tests. A shape added here is in both.
#pragma once

#include "scenes.hpp"

#include <passive_haptics/scene/mesh/height_field.hpp>
#include <passive_haptics/scene/mesh/mesh_solid.hpp>
#include <passive_haptics/scene/mesh/mesh_surface.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/box.hpp>
#include <passive_haptics/scene/shapes/capsule.hpp>
#include <passive_haptics/scene/shapes/complement.hpp>
#include <passive_haptics/scene/shapes/convex_polygon.hpp>
#include <passive_haptics/scene/shapes/convex_polytope.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/scene/shapes/offset.hpp>
#include <passive_haptics/scene/shapes/virtual_fixtures.hpp>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

namespace experiments {

namespace ph = passive_haptics;

// The place of first contact with a specimen, a point of its surface.
template <int D>
struct place {
  ph::point<D> at, normal, along;  // [m], outward normal, direction of the hand (orthonormal)
  double radius = 60e-3;           // radius of curved specimens and scale of others [m]
  int fine = 72;                   // corners of a circle that feels smooth

  // The point at these multiples of the radius.
  ph::point<D> point(double forward, double up, double across = 0) const {
    return at + radius * (axes() * coordinates(forward, up, across));
  }
  ph::point<D> direction(double forward, double up) const { return axes() * coordinates(forward, up, 0); }
  // Columns: along, across (spatial only), normal.
  ph::matrix<double, D, D> axes() const {
    ph::matrix<double, D, D> all;
    all.col(0) = along;
    if constexpr (D == 3) all.col(1) = normal.cross(along);
    all.col(D - 1) = normal;
    return all;
  }
  // A box from its centre and half extents in multiples of the radius; rotated about the axis across.
  ph::box<D> box(double forward, double up, double half_along, double half_up, double turn = 0) const {
    ph::box_parameters<D> p{point(forward, up), radius * coordinates(half_along, half_up, 1.5), axes()};
    const double c = std::cos(turn), s = std::sin(turn);
    p.axes.col(0) = direction(c, s);
    p.axes.col(D - 1) = direction(-s, c);
    return ph::box<D>(p);
  }
  // A bar across the path with circular cross-section; planar bars extend downwards or upwards.
  ph::capsule<D> bar(double up, double thickness, double end) const {
    return D == 3 ? ph::capsule<D>(point(0, up, -2), point(0, up, 2), thickness * radius)
                  : ph::capsule<D>(point(0, up), point(0, end), thickness * radius);
  }
  ph::ball<D> ball(double up, ph::filling f = ph::filling::solid) const {
    return ph::ball<D>(point(0, up), radius, f);
  }
  ph::half_space<D> plane(double up, double slope = 0) const {
    return ph::half_space<D>(point(0, up), direction(-std::sin(slope), std::cos(slope)));
  }

  // The mesh of a profile (forward, up) that is solid on the right, extruded across. A closed one gets ends,
  // and must be star-shaped about `middle`.
  using profile = std::vector<ph::vector<double, 2>>;
  ph::mesh<D> mesh(const profile& corners, bool closed, const ph::vector<double, 2>& middle = {0, 0}) const {
    ph::mesh_parameters<D> m;
    const int n = static_cast<int>(corners.size()), sides = closed ? n : n - 1;
    const auto facet = [&](auto... corner) { m.facets.push_back({corner...}); };
    for (const double across : {-1.5, 1.5}) {
      for (const auto& c : corners) m.vertices.push_back(point(c[0], c[1], across));
      if (D == 2) break;
    }
    if constexpr (D == 2) {
      for (int i = 0; i < sides; ++i) facet(i, (i + 1) % n);
    } else {
      for (const double across : {-1.5, 1.5}) m.vertices.push_back(point(middle[0], middle[1], across));
      for (int i = 0; i < sides; ++i) {
        const int j = (i + 1) % n;
        facet(i, n + j, j);
        facet(i, n + i, n + j);
        if (!closed) continue;
        facet(2 * n, i, j);
        facet(2 * n + 1, n + j, n + i);
      }
    }
    if (ph::mesh<D>(m)[0].normal.dot(left_of_first(corners)) < 0)
      for (auto& f : m.facets) std::swap(f[0], f[1]);
    return ph::mesh<D>(m);
  }

  static profile circle(double middle, int corners) {
    profile p;
    for (int k = 0; k < corners; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.5) / corners;
      p.push_back({std::sin(angle), middle + std::cos(angle)});
    }
    return p;
  }
  static profile from_behind(profile p) { return {p.rbegin(), p.rend()}; }
  ph::mesh<D> block(double from, double to) const {
    return mesh({{from, 0}, {to, 0}, {to, -1}, {from, -1}}, true, {(from + to) / 2, -0.5});
  }
  ph::mesh<D> ridge() const { return mesh({{0, 0}, {1, -1}, {0, -2}, {-1, -1}}, true, {0, -1}); }
  ph::mesh<D> round() const { return mesh(circle(-1, fine), true, {0, -1}); }
  // The 12 corners of a regular polygon.
  ph::convex_polygon<12> polygon(double middle) const
    requires(D == 2)
  {
    ph::convex_polygon_parameters<12> p;
    const profile c = circle(middle, 12);
    for (std::size_t k = 0; k < 12; ++k) p.corners[k] = point(c[k][0], c[k][1]);
    return ph::convex_polygon<12>(p);
  }

 private:
  static ph::point<D> coordinates(double forward, double up, [[maybe_unused]] double across) {
    if constexpr (D == 2) return {forward, up};
    else return {forward, across, up};
  }
  ph::point<D> left_of_first(const profile& corners) const {
    const ph::vector<double, 2> side = corners[1] - corners[0];
    return direction(-side[1], side[0]);
  }
};

template <class Make>
struct specimen {
  const char* name;
  surface meant;
  Make make;             // makes a shape, or a tuple of shapes, at a place
  bool is_thin = false;  // less than twice a hand's depth
};
template <class Make>
specimen(const char*, surface, Make, bool = false) -> specimen<Make>;

inline constexpr double rounded_edge = 0.1;  // radius of the path over an edge, by that of curved specimens
inline constexpr double quarter = std::numbers::pi / 4;

// The first of each surface is the reference of the others. Those that accept a place<2> or place<3> are
// planar or spatial only.
inline constexpr auto specimens = std::make_tuple(
    specimen{"half_space", surface::plane, [](const auto& p) { return p.plane(0); }},
    specimen{"ball", surface::solid, [](const auto& p) { return p.ball(-1); }},
    specimen{"ball, hollow", surface::hollow, [](const auto& p) { return p.ball(1, ph::filling::hollow); }},
    specimen{"convex_polytope, edge", surface::edge,
             [](const auto& p) { return ph::convex_polytope(p.plane(0, quarter), p.plane(0, -quarter)); }},
    specimen{"complement(half_space)", surface::plane,
             [](const auto& p) {
               return ph::complement(decltype(p.plane(0))(p.at, -p.normal));
             }},
    specimen{"box", surface::plane, [](const auto& p) { return p.box(0, -1, 1.5, 1); }},
    specimen{"convex_polytope", surface::plane,
             [](const auto& p) { 
               return ph::convex_polytope(p.plane(0), decltype(p.plane(0))(p.point(0, -1), -p.normal));
             }},
    specimen{"convex_polygon", surface::plane,
             [](const place<2>& p) {
               return ph::convex_polygon<5>(
                   {p.point(-1.5, 0), p.point(1.5, 0), p.point(2, -0.8), p.point(0, -1.5), p.point(-2, -0.8)});
             }},
    specimen{"offset(box), grown", surface::plane,
             [](const auto& p) { return ph::offset(p.box(0, -1, 1.5, 0.8), 0.2 * p.radius); }},
    specimen{"offset(box), shrunk", surface::plane,
             [](const auto& p) { return ph::offset(p.box(0, -0.8, 1.5, 1), -0.2 * p.radius); }},
    specimen{"mesh_solid", surface::plane,
             [](const auto& p) { return ph::mesh_solid(p.block(-1.5, 1.5)); }},
    specimen{"mesh_surface", surface::plane,
             [](const auto& p) { return ph::mesh_surface(p.mesh({{-1.5, 0}, {1.5, 0}}, false)); }},
    specimen{"slot of 6 mm", surface::plane,
             [](const auto& p) {
               return std::tuple(p.plane(0), decltype(p.plane(0))(p.point(0, 0.1), -p.normal));
             }},
    specimen{"two boxes side by side", surface::plane,
             [](const auto& p) { return std::tuple(p.box(-1, -1, 1, 1), p.box(1, -1, 1, 1)); }},
    specimen{"two mesh_solids side by side", surface::plane,
             [](const auto& p) {
               return std::tuple(ph::mesh_solid(p.block(-2, 0)), ph::mesh_solid(p.block(0, 2)));
             }},
    specimen{"box of 3 mm", surface::plane, [](const auto& p) { return p.box(0, -0.025, 1.5, 0.025); }, true},
    specimen{"capsule of 3 mm", surface::plane,
             [](const place<2>& p) {
               return ph::capsule<2>(p.point(-1.5, -0.025), p.point(1.5, -0.025), 0.025 * p.radius);
             },
             true},
    specimen{"capsule", surface::solid, [](const auto& p) { return p.bar(-1, 1, -2); }},
    specimen{"offset(box), edge", surface::solid,
             [](const auto& p) { return ph::offset(p.box(0, -1 - std::numbers::sqrt2, 1, 1, quarter), p.radius); }},
    specimen{"offset(capsule)", surface::solid,
             [](const auto& p) { return ph::offset(p.bar(-1, 0.5, -2), 0.5 * p.radius); }},
    specimen{"convex_polygon of 12", surface::solid, [](const place<2>& p) { return p.polygon(-1); }},
    specimen{"mesh_solid, round", surface::solid, [](const auto& p) { return ph::mesh_solid(p.round()); }},
    specimen{"mesh_surface, round", surface::solid, [](const auto& p) { return ph::mesh_surface(p.round()); }},
    specimen{"complement(ball)", surface::hollow, [](const auto& p) { return ph::complement(p.ball(1)); }},
    specimen{"tube", surface::hollow, [](const auto& p) { return ph::complement(p.bar(1, 1, 2)); }},
    specimen{"complement(convex_polygon of 12)", surface::hollow,
             [](const place<2>& p) { return ph::complement(p.polygon(1)); }},
    specimen{"complement(mesh_solid)", surface::hollow,
             [](const auto& p) {
               return ph::complement(ph::mesh_solid(p.mesh(p.circle(1, p.fine), true, {0, 1})));
             }},
    specimen{"mesh_surface, hollow", surface::hollow,
             [](const auto& p) {
               return ph::mesh_surface(p.mesh(p.from_behind(p.circle(1, p.fine)), true, {0, 1}));
             }},
    specimen{"height_field", surface::hollow,
             [](const place<3>& p) {
               constexpr int n = 19;
               const double spacing = 0.07 * p.radius, half = (n - 1) * spacing / 2;
               ph::height_field_parameters field{n, n, spacing, spacing, {}, p.at - ph::point<3>(half, half, 0)};
               for (int k = 0; k < n * n; ++k) {
                 const double r = std::hypot(k % n * spacing - half, k / n * spacing - half);
                 field.heights.push_back(p.radius - std::sqrt(p.radius * p.radius - r * r));
               }
               return ph::mesh_surface<3>(ph::triangle_mesh(ph::height_field(field)));
             }},
    specimen{"box, edge", surface::edge,
             [](const auto& p) { return p.box(0, -std::numbers::sqrt2, 1, 1, quarter); }},
    specimen{"mesh_solid, edge", surface::edge, [](const auto& p) { return ph::mesh_solid(p.ridge()); }},
    specimen{"mesh_surface, edge", surface::edge, [](const auto& p) { return ph::mesh_surface(p.ridge()); }});

// Calls f(specimen) for each one in D dimensions.
template <int D, class F>
void for_each_specimen(F&& f) {
  const auto each = [&]<class Make>(const specimen<Make>& s) {
    if constexpr (std::is_invocable_v<Make, const place<D>&>) f(s);
  };
  std::apply([&](const auto&... s) { (each(s), ...); }, specimens);
}

}  // namespace experiments
