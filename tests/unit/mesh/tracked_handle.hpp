// A handle that is led along a tracked shape, and what it feels.
#pragma once

#include <passive_haptics/scene/mesh/mesh_surface.hpp>

#include <vector>

namespace tracked {
namespace ph = passive_haptics;

template <int D>
struct touch {
  ph::point<D> normal;
  double depth;
};

template <int D>
struct handle {
  ph::mesh_surface<D> shape;
  typename ph::mesh_surface<D>::tracker memory{};
  ph::point<D> x = ph::point<D>::Zero();
  std::vector<touch<D>> felt{};

  explicit handle(ph::mesh_surface<D> s) : shape(std::move(s)) {}

  auto adder() {
    felt.clear();
    return [this](const ph::point<D>& normal, double depth) { felt.push_back({normal, depth}); };
  }

  // One cycle; returns how far it may go from there.
  double go(const ph::point<D>& to) {
    const double may_go = shape.follow(x, to, memory, adder());
    x = to;
    return may_go;
  }

  ph::point<D> proxy() const { return memory.held ? ph::point<D>(memory.position.data()) : x; }

  // < 0 behind the surface of a closed mesh
  double distance_of_proxy() const {
    return shape.surface().signed_distance(proxy(), shape.surface().nearest(proxy()));
  }
};

}  // namespace tracked
