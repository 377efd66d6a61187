/// A surface of segments (2-D) or triangles (3-D), with nearest points and normals.
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
  int facet;  ///< Index of its facet.

  /// Distance from the query point [m].
  double distance() const { return std::sqrt(this->squared_distance); }
};

/// An immutable surface. Copies share it, any number of threads may search it, and no search allocates.
template <int D>
class mesh {
 public:
  static constexpr int dimension = D;  ///< d

  /// Builds the surface in O(n log n). Throws std::invalid_argument with the text of validate(p).
  explicit mesh(const mesh_parameters<D>& p) : data_(std::make_shared<const data>(require_valid(p))) {}

  int size() const { return static_cast<int>(data_->facets.size()); }  ///< Number of facets.

  /// Facet i, 0 <= i < size(), in the order of the parameters.
  const mesh_facet<D>& operator[](int i) const { return nth(data_->facets, i); }

  /// True if the facets enclose their wall or their free space without a hole and with one orientation.
  bool closed() const { return data_->hole.empty(); }

  /// The reason why the mesh is not closed, with vertices and facets; empty if it is closed.
  const std::string& hole() const { return data_->hole; }

  /// Number of edges (2-D: vertices) with two facets of opposite orientation.
  int turned_edges() const { return data_->turned_edges; }

  /// Enclosed area [m^2] (2-D) or volume [m^3] (3-D) of a closed mesh; < 0 if the outside is solid.
  double content() const { return data_->content; }

  const bounding_box<D>& bounds() const { return data_->bounds; }  ///< Bounding box of all facets.

  const bounding_volume_tree<D>& tree() const { return data_->tree; }  ///< Tree of the facets' boxes.

  /// Returns the nearest point of the surface, in about log n. The search starts with facet `guess`, ideally
  /// the result for a neighbouring x. NaN in x gives a NaN distance.
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

  /// Unit normal of the surface at one of its points. On an edge or corner it is the sum of the facets'
  /// normals weighted by their angles there. x is in front of a closed mesh if normal . (x - nearest) > 0.
  /// Reference: J. A. Baerentzen, H. Aanaes, Signed distance computation using the angle weighted
  /// pseudonormal, IEEE Trans. Visualization and Computer Graphics 11 (3), 2005, pp. 243-253.
  const point<D>& normal_at(const mesh_point<D>& p) const {
    const auto f = static_cast<std::size_t>(p.facet), i = static_cast<std::size_t>(p.index);
    if (p.part == facet_part::interior) return data_->facets[f].normal;
    if (p.part == facet_part::edge) return nth(data_->edge_normals, data_->edges[f][i]);
    return nth(data_->vertex_normals, data_->vertices[f][i]);
  }

  /// Distance from x to its nearest point [m]; < 0 behind the surface of a closed mesh.
  double signed_distance(const point<D>& x, const mesh_point<D>& nearest) const {
    return normal_at(nearest).dot(x - nearest.position) < 0 ? -nearest.distance() : nearest.distance();
  }

 private:
  using indices = std::array<int, static_cast<std::size_t>(D)>;

  struct data {
    std::vector<mesh_facet<D>> facets;
    std::vector<indices> vertices, edges;  // indices of the normals below, by facet
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
      for (std::size_t f = 0; f < facets.size(); ++f) {  // for facets back to back, any of them
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

/// A spatial mesh.
using triangle_mesh = mesh<3>;
/// A planar mesh.
using polyline = mesh<2>;

}  // namespace passive_haptics
