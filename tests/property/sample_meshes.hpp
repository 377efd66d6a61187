// Meshes that tests make themselves.
#pragma once

#include <passive_haptics/scene/mesh/mesh_parameters.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <cmath>
#include <numbers>

namespace sample_meshes {
namespace ph = passive_haptics;

// The surface of the box between two corners; its normals point out of it.
template <int D>
ph::mesh_parameters<D> box(const ph::point<D>& lower, const ph::point<D>& upper) {
  ph::mesh_parameters<D> m;
  for (unsigned k = 0; k < 1u << D; ++k) {
    ph::point<D> corner;
    for (int i = 0; i < D; ++i) corner[i] = (k >> i & 1u) != 0 ? upper[i] : lower[i];
    m.vertices.push_back(corner);
  }
  if constexpr (D == 2) m.facets = {{0, 1}, {1, 3}, {3, 2}, {2, 0}};
  else
    m.facets = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return m;
}

// Every facet the other way round.
template <int D>
ph::mesh_parameters<D> inside_out(ph::mesh_parameters<D> m) {
  for (auto& f : m.facets) std::swap(f[0], f[1]);
  return m;
}

// Both surfaces.
template <int D>
ph::mesh_parameters<D> both(ph::mesh_parameters<D> a, const ph::mesh_parameters<D>& b) {
  const int shift = static_cast<int>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (auto f : b.facets) {
    for (int& v : f) v += shift;
    a.facets.push_back(f);
  }
  return a;
}

// Every facet with vertices of its own, as in an STL file.
template <int D>
ph::mesh_parameters<D> loose(const ph::mesh_parameters<D>& m) {
  ph::mesh_parameters<D> apart;
  for (std::size_t f = 0; f < m.facets.size(); ++f) {
    std::array<int, static_cast<std::size_t>(D)> indices{};
    for (std::size_t i = 0; i < indices.size(); ++i) {
      indices[i] = static_cast<int>(apart.vertices.size());
      apart.vertices.push_back(m.corners(f)[i]);
    }
    apart.facets.push_back(indices);
  }
  return apart;
}

// A globe: radius(direction) [m] from the origin at each vertex, `around` meridians, and poles where needles
// meet.
template <class Radius>
ph::mesh_parameters<3> globe(int around, int rings, const Radius& radius) {
  ph::mesh_parameters<3> m;
  const auto add = [&](double latitude, double longitude) {
    const ph::point<3> u(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                         std::sin(latitude));
    m.vertices.push_back(radius(u) * u);
  };
  const double pi = std::numbers::pi;
  add(-pi / 2, 0);
  for (int r = 1; r < rings; ++r) {
    for (int a = 0; a < around; ++a) add(pi * (double(r) / rings - 0.5), 2 * pi * a / around);
  }
  add(pi / 2, 0);
  const auto at = [&](int r, int a) { return 1 + (r - 1) * around + a % around; };
  const int top = static_cast<int>(m.vertices.size()) - 1;
  for (int a = 0; a < around; ++a) {
    m.facets.push_back({0, at(1, a + 1), at(1, a)});
    for (int r = 1; r + 1 < rings; ++r) {
      m.facets.push_back({at(r, a), at(r, a + 1), at(r + 1, a + 1)});
      m.facets.push_back({at(r, a), at(r + 1, a + 1), at(r + 1, a)});
    }
    m.facets.push_back({top, at(rings - 1, a), at(rings - 1, a + 1)});
  }
  return m;
}

// The same in the plane.
template <class Radius>
ph::mesh_parameters<2> ring(int around, const Radius& radius) {
  ph::mesh_parameters<2> m;
  for (int a = 0; a < around; ++a) {
    const double angle = 2 * std::numbers::pi * a / around;
    const ph::point<2> u(std::cos(angle), std::sin(angle));
    m.vertices.push_back(radius(u) * u);
    m.facets.push_back({a, (a + 1) % around});
  }
  return m;
}

// Closed, with deep valleys and sharp peaks; all points of it are seen from the origin.
template <int D>
ph::mesh_parameters<D> star(ph::testing::random_source& random, int around) {
  const auto radius = [&](const auto&) { return random.uniform(0.3, 1.0); };
  if constexpr (D == 2) return ring(around, radius);
  else return globe(around, around / 2, radius);
}

// How far the mesh lies within the ball of this radius about the origin, on which all its vertices are, at
// most [m].
template <int D>
double sagitta(const ph::mesh_parameters<D>& m, double radius) {
  double largest = 0;
  for (std::size_t f = 0; f < m.facets.size(); ++f) {
    const auto corners = m.corners(f);
    largest = std::max(largest, radius - ph::detail::normal_of(corners).dot(corners[0]));
  }
  return largest;
}

}  // namespace sample_meshes
