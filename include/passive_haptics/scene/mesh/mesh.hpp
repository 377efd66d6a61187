/// @file
/// A surface of segments (2-D) or triangles (3-D) and the point of it nearest to another.
#pragma once

#include <passive_haptics/core/flatten.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/scene/bounds/bounding_volume_tree.hpp>
#include <passive_haptics/scene/mesh/mesh_topology.hpp>

#include <memory>
#include <string>
#include <vector>

namespace passive_haptics {

/// A point of a mesh.
template <int D>
struct mesh_point : facet_point<D> {
  int facet;  ///< On which facet.

  /// From the point that it is nearest to [m].
  double distance() const { return std::sqrt(this->squared_distance); }
};

/// A surface that never changes: its copies share it, any number of threads may search it, and no search
/// allocates.
template <int D>
class mesh {
 public:
  static constexpr int dimension = D;  ///< d

  /// Throws std::invalid_argument with the text of validate(p). O(n log n).
  explicit mesh(const mesh_parameters<D>& p) : data_(std::make_shared<const data>(require_valid(p))) {}

  /// Number of facets.
  int size() const { return static_cast<int>(data_->facets.size()); }

  /// Facet i, 0 <= i < size(), in the order of the parameters.
  const mesh_facet<D>& operator[](int i) const { return nth(data_->facets, i); }

  /// True if the facets enclose their wall or their free space without a hole, all running the same way
  /// round.
  bool closed() const { return data_->hole.empty(); }

  /// Why it is not closed, by vertices and facets; empty if it is.
  const std::string& hole() const { return data_->hole; }

  /// Edges (2-D: vertices) whose two facets run the same way along them, so that one of both faces the wrong
  /// side.
  int turned_edges() const { return data_->turned_edges; }

  /// Enclosed area [m^2] (2-D) or volume [m^3] (3-D) of a closed mesh; < 0 if the outside is solid.
  double content() const { return data_->content; }

  /// The box about all facets.
  const bounding_box<D>& bounds() const { return data_->bounds; }

  /// The facets by their boxes.
  const bounding_volume_tree<D>& tree() const { return data_->tree; }

  /// The nearest point of the surface; starts with facet `guess`, best that of a neighbouring x. About log n.
  /// A NaN in x gives a NaN distance.
  PASSIVE_HAPTICS_FLATTEN mesh_point<D> nearest(const point<D>& x, int guess = 0) const {
    mesh_point<D> best{nearest_point((*this)[guess], x), guess};
    double limit = best.squared_distance;
    auto search = data_->tree.start();
    data_->tree.go_on(search, squared_distance_from<D>(x), limit, [&](int place, double) {
      const int i = data_->tree.item(place);
      if (i == guess) return;
      const auto candidate = nearest_point((*this)[i], x, limit);
      if (!(candidate.squared_distance < limit)) return;
      best = {candidate, i};
      limit = candidate.squared_distance;
    });
    return best;
  }

  /// The unit normal of the surface at one of its points: of an edge or a corner that of its facets, weighted
  /// by their angles there. Whether x is in front of the surface of a closed mesh is the sign of this . (x -
  /// nearest). Reference: J. A. Baerentzen, H. Aanaes, Signed distance computation using the angle weighted
  /// pseudonormal, IEEE Trans. Visualization and Computer Graphics 11 (3), 2005, pp. 243-253.
  const point<D>& normal_at(const mesh_point<D>& p) const {
    const auto f = static_cast<std::size_t>(p.facet), i = static_cast<std::size_t>(p.index);
    if (p.part == facet_part::interior) return data_->facets[f].normal;
    if (p.part == facet_part::edge) return nth(data_->edge_normals, data_->edges[f][i]);
    return nth(data_->vertex_normals, data_->vertices[f][i]);
  }

  /// Distance from x to its nearest point [m], < 0 behind the surface of a closed mesh.
  double signed_distance(const point<D>& x, const mesh_point<D>& nearest) const {
    return normal_at(nearest).dot(x - nearest.position) < 0 ? -nearest.distance() : nearest.distance();
  }

 private:
  using indices = std::array<int, static_cast<std::size_t>(D)>;

  struct data {
    std::vector<mesh_facet<D>> facets;
    std::vector<indices> vertices, edges;  // of each facet, indices of the normals below
    std::vector<point<D>> vertex_normals, edge_normals;
    bounding_volume_tree<D> tree;
    bounding_box<D> bounds;
    std::string hole;
    int turned_edges = 0;
    double content;

    explicit data(const mesh_parameters<D>& p) : vertices(p.facets), edges(p.facets.size()) {
      const std::vector<int> first = detail::welded<D>(p.vertices);
      std::vector<bounding_box<D>> boxes(p.facets.size());
      facets.reserve(p.facets.size());
      for (std::size_t f = 0; f < p.facets.size(); ++f) {
        for (int& v : vertices[f]) v = nth(first, v);
        const auto corners = p.corners(f);
        facets.push_back({corners, detail::normal_of(corners)});
        for (const point<D>& c : corners) boxes[f].extend(c);
        bounds.extend(boxes[f]);
      }
      tree = bounding_volume_tree<D>(boxes);
      find_vertex_normals(p.vertices.size());
      find_edges();
      content = detail::enclosed(facets) / (D == 2 ? 2 : 6);
    }

    void find_vertex_normals(std::size_t count) {
      vertex_normals.assign(count, point<D>::Zero());
      const auto normal_at = [&](std::size_t f, std::size_t i) -> point<D>& {
        return nth(vertex_normals, vertices[f][i]);
      };
      for (std::size_t f = 0; f < facets.size(); ++f) {
        const auto angles = detail::angles_of<D>(facets[f].corners);
        for (std::size_t i = 0; i < D; ++i) normal_at(f, i) += angles[i] * facets[f].normal;
      }
      for (point<D>& n : vertex_normals) n = detail::direction_or<D>(n, n);
      for (std::size_t f = 0; f < facets.size(); ++f) {  // of facets back to back, any of them will do
        for (std::size_t i = 0; i < D; ++i)
          if (normal_at(f, i).isZero(0)) normal_at(f, i) = facets[f].normal;
      }
    }

    void find_edges() {
      const auto ridges = detail::sorted_ridges<D>(vertices);
      for (auto r = ridges.data(), end = r + ridges.size(); r != end;) {
        const auto first = r;
        point<D> sum = point<D>::Zero();
        for (; r != end && r->same_place(*first); ++r) {
          const auto f = static_cast<std::size_t>(r->facet);
          sum += facets[f].normal;
          nth(edges[f], r->index) = static_cast<int>(edge_normals.size());
        }
        edge_normals.push_back(detail::direction_or<D>(sum, nth(facets, first->facet).normal));
        if (r - first == 2 && first->turn == first[1].turn) ++turned_edges;
        if (hole.empty()) hole = detail::check_ridge<D>(first, r);
      }
    }
  };

  std::shared_ptr<const data> data_;
};

/// A mesh in space.
using triangle_mesh = mesh<3>;
/// A mesh in the plane.
using polyline = mesh<2>;

}  // namespace passive_haptics
