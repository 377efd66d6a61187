// Specimens in scenes of every kind, type-erased.
#pragma once

#include "specimens.hpp"

#include <passive_haptics/runtime/any_scene.hpp>
#include <passive_haptics/runtime/any_shape.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/shapes/moving.hpp>
#include <passive_haptics/scene/world/world.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace experiments {

using ph::runtime::any_scene, ph::runtime::any_shape;

// A type-erased specimen at a place.
template <int D>
struct placed_specimen {
  std::vector<any_shape<D>> shapes;     // of a scene; none if a mesh_surface needs a world
  std::vector<ph::any_wall<D>> walls;   // of a world
  std::shared_ptr<any_shape<D>> felt;   // for measuring depths
  std::shared_ptr<any_shape<D>> meant;  // path of the hand
};

// The first specimen of a surface, the reference for the others.
template <int D>
any_shape<D> reference_shape(surface of, const place<D>& p) {
  switch (of) {
    case surface::plane: return any_shape<D>(p.plane(0));
    case surface::solid: return any_shape<D>(p.ball(-1));
    case surface::hollow: return any_shape<D>(p.ball(1, ph::filling::hollow));
    case surface::edge: return any_shape<D>(ph::convex_polytope(p.plane(0, quarter), p.plane(0, -quarter)));
  }
  throw std::logic_error("a surface without a reference");
}

// A mesh_surface near its facets.
template <class S>
struct sheet {
  static constexpr int dimension = S::dimension;
  static constexpr bool has_unit_gradient = true;
  using at = ph::point<dimension>;
  ph::mesh<dimension> mesh;
  explicit sheet(const S& s) : mesh(s.surface()) {}
  double distance(const at& x) const { return mesh.signed_distance(x, mesh.nearest(x)); }
  at gradient(const at& x) const { return mesh.normal_at(mesh.nearest(x)).normalized(); }
};

template <int D>
struct any_specimen : scene_specimen {
  std::function<placed_specimen<D>(const place<D>&)> at;
};

template <int D>
std::vector<any_specimen<D>> all_specimens() {
  std::vector<any_specimen<D>> all;
  for_each_specimen<D>([&]<class Make>(const specimen<Make>& s) {
    using made = std::invoke_result_t<Make, const place<D>&>;
    constexpr bool is_shape = ph::Shape<made>, is_surface = ph::TrackedShape<made> && !is_shape;
    scene_specimen row{s.name, s.meant, s.is_thin, is_surface};
    row.is_mesh = row.name.find("mesh") != std::string::npos || is_surface;
    if constexpr (!is_shape && !is_surface) row.walls = std::tuple_size_v<made>;
    all.push_back({row, [s](const place<D>& p) {
                     placed_specimen<D> placed;
                     const any_shape<D> reference = reference_shape(s.meant, p);
                     placed.felt = placed.meant = std::make_shared<any_shape<D>>(reference);
                     if (s.meant == surface::edge)
                       placed.meant = std::make_shared<any_shape<D>>(
                           ph::offset(p.box(0, -(1 + rounded_edge) * std::numbers::sqrt2, 1, 1, quarter),
                                      rounded_edge * p.radius));
                     const auto add = [&placed]<class S>(const S& shape) {
                       if constexpr (!is_surface) placed.shapes.emplace_back(shape);
                       placed.walls.emplace_back(ph::wall(shape));
                     };
                     const made shapes = s.make(p);
                     if constexpr (is_shape || is_surface) add(shapes);
                     else std::apply([&](const auto&... each) { (add(each), ...); }, shapes);
                     if constexpr (is_surface) placed.felt = std::make_shared<any_shape<D>>(sheet(shapes));
                     else if constexpr (is_shape)
                       if (!s.is_thin) placed.felt = std::make_shared<any_shape<D>>(shapes);
                     return placed;
                   }});
  });
  return all;
}

// A scene with walls that are moved before it is sensed.
template <class Scene, class Move>
struct moved_scene {
  static constexpr int dimension = Scene::dimension;
  using contacts_type = typename Scene::contacts_type;
  Scene scene;
  Move move;  // moves its walls to a time [s]
  decltype(auto) touched_at(const ph::point<dimension>& x, double time) {
    move(scene, time);
    if constexpr (requires { scene.touched_at(x, time); }) return scene.touched_at(x, time);
    else return scene.touched_at(x);
  }
  void set_margin(double margin) { scene.set_margin(margin); }
};
template <class Scene, class Move>
moved_scene(Scene, Move) -> moved_scene<Scene, Move>;

// A small mesh 5 m away.
template <int D>
ph::any_wall<D> far_mesh(place<D> p) {
  p.at.array() += 5;
  return ph::any_wall<D>(ph::wall(ph::mesh_solid<D>(p.block(-0.5, 0.5))));
}

// The scene of this kind. At a time, its walls are displaced outward by `speed` times (time - middle).
template <int D>
any_scene<D> scene_of(const scene_kind& kind, const placed_specimen<D>& placed, const place<D>& p,
                      double middle) {
  const ph::point<D> velocity = kind.speed * p.normal;
  const auto made = [&](auto scene, auto move) {
    if (!kind.is_slow) return any_scene<D>(moved_scene{std::move(scene), move});
    return any_scene<D>(moved_scene{ph::held_scene(std::move(scene), 0.05),
                                    [move](auto& held, double time) { move(held.scene(), time); }});
  };
  if (kind.is_world) {
    using world = ph::world<D>;
    ph::world_walls<D> walls;
    for (const auto& w : placed.walls) kind.speed != 0 ? walls.add_moving(w) : walls.add(w);
    const int count = static_cast<int>(placed.walls.size());
    if (kind.has_mesh) walls.add(far_mesh(p));
    return made(world(walls), [=](world& w, double time) {
      for (int k = 0; k < count && kind.speed != 0; ++k)
        w.set_motion(k, (time - middle) * velocity, velocity);
    });
  }
  std::vector<ph::moving<any_shape<D>>> shapes;
  for (const auto& s : placed.shapes) shapes.emplace_back(s);
  const auto of = [&]<int... k>(std::integer_sequence<int, k...>) {
    auto scene = ph::scene(ph::wall(shapes[std::size_t(k)])...);
    return made(scene, [=](decltype(scene)& s, double time) {
      (s.template get<k>().shape.set_motion((time - middle) * velocity, velocity), ...);
    });
  };
  if (kind.has_bar)
    shapes.emplace_back(any_shape<D>(p.bar(10e-3 / p.radius, 5e-3 / p.radius, 30e-3 / p.radius)));
  if (shapes.size() == 2) return of(std::make_integer_sequence<int, 2>());
  if (shapes.size() == 3) return of(std::make_integer_sequence<int, 3>());
  return of(std::make_integer_sequence<int, 1>());
}

}  // namespace experiments
