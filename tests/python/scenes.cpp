// Meshes, worlds, held scenes and effects.
#include "reference.hpp"

#include <passive_haptics/control/pipelines/with_effects.hpp>
#include <passive_haptics/force/effects/detents.hpp>
#include <passive_haptics/force/effects/end_stops.hpp>
#include <passive_haptics/force/effects/guide.hpp>
#include <passive_haptics/force/effects/rough_walls.hpp>
#include <passive_haptics/force/effects/viscous_field.hpp>
#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/mesh/mesh_solid.hpp>
#include <passive_haptics/scene/mesh/mesh_surface.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/world/world.hpp>

namespace reference {
namespace {

// Of a file: numbers of vertices, facets and balls, then vertices, facets, and of each ball centre and
// radius.
template <int D>
struct shapes {
  explicit shapes(const std::string& path) {
    doubles_in in(path);
    const auto sizes = in.numbers<3>();
    for (int i = 0; i < int(sizes[0]); ++i) mesh.vertices.push_back(in.numbers<D>());
    for (int i = 0; i < int(sizes[1]); ++i) {
      const auto facet = in.numbers<D>();
      mesh.facets.emplace_back();
      for (int k = 0; k < D; ++k) mesh.facets.back()[std::size_t(k)] = int(facet[k]);
    }
    for (int i = 0; i < int(sizes[2]); ++i) {
      const auto centre = in.numbers<D>();
      balls.emplace_back(centre, in.number());
    }
  }

  ph::mesh_parameters<D> mesh;
  std::vector<ph::ball<D>> balls;
};

// Balls, a plane, a solid, and a surface that lies beside it.
template <int D>
ph::world<D> world_of(const shapes<D>& all, const ph::half_space<D>& plane, double stiffness) {
  ph::world_walls<D> walls;
  for (const auto& ball : all.balls) walls.add(ph::wall(ball, stiffness));
  walls.add(ph::wall(plane, 2 * stiffness));
  walls.add(ph::wall(ph::mesh_solid<D>(ph::mesh<D>(all.mesh)), stiffness));
  auto beside = all.mesh;
  for (auto& x : beside.vertices) x[0] += 0.015;
  walls.add(ph::wall(ph::mesh_surface<D>(ph::mesh<D>(beside)), 3 * stiffness));
  return ph::world<D>(walls);
}

// A scene with each effect of the library.
template <int D, class S>
auto beside_effects(const S& scene, const ph::point<D>& point) {
  const ph::point<D> diagonal = ph::point<D>::Ones();
  ph::viscous_field_parameters<double, D> field;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) field.viscosity(i, j) = i == j ? 3 - i : i < j ? 1 : -1;
  ph::guide_parameters<double, D> rail;
  rail.point = point;
  rail.direction = diagonal;
  rail.stiffness = 200;
  rail.tolerance = 0.002;
  rail.viscosity = 1;
  ph::detents_parameters<double, D> clicks;
  clicks.origin = point;
  clicks.direction = diagonal;
  clicks.spacing = 0.01;
  clicks.strength = 1.5;
  ph::end_stops_parameters<double, D> stops;
  stops.lower.setConstant(0.3);
  stops.upper.setConstant(0.6);
  stops.stiffness.setConstant(5);
  return ph::with_effects(scene, ph::viscous_field<double, D>(field), ph::rough_walls<double, D>({0.3, 1}),
                          ph::guide<double, D>(rail), ph::end_stops<double, D>(stops),
                          ph::detents<double, D>(clicks));
}

template <class M, class S, class L>
bool run_in(const M& mechanism, const task<M>& given, const S& scene, const L& law, const std::string& to) {
  ph::controller control(mechanism, given.brakes, scene, law);
  doubles_out out(to);
  for (const auto& state : given.states) out.add_result(control(state));
  return true;
}

template <class M>
bool run_mode(const M& mechanism, const std::string& law, const std::string& mode, const std::string& in,
              const std::string& to) {
  constexpr int d = M::task_dimension;
  constexpr double period = 0.02;  // [s], of cycles of 1 ms
  const task<M> given(in);
  const shapes<d> of(in + ".shapes");
  const ph::half_space<d> plane(given.point, given.normal);
  const auto solid = ph::scene(ph::wall(ph::mesh_solid<d>(ph::mesh<d>(of.mesh)), given.stiffness));
  const auto under = [&](const auto& chosen) {
    if (mode == "held") return run_in(mechanism, given, ph::held_scene(given.scene(), period), chosen, to);
    if (mode == "mesh_solid") return run_in(mechanism, given, solid, chosen, to);
    if constexpr (!ph::saturates_before_scaling<std::remove_cvref_t<decltype(chosen)>>) {
      const auto world = world_of(of, plane, given.stiffness);
      if (mode == "world") return run_in(mechanism, given, world, chosen, to);
      if (mode == "held_world") return run_in(mechanism, given, ph::held_scene(world, period), chosen, to);
    }
    return false;
  };
  if (law == "direct_control in scenes" && mode == "effects")
    return run_in(mechanism, given, beside_effects<d>(given.scene(), given.point), ph::direct_control(), to);
  if (law == "direct_control in scenes" && mode == "effects_in_world")
    return run_in(mechanism, given, beside_effects<d>(world_of(of, plane, given.stiffness), given.point),
                  ph::direct_control(), to);
  if (law == "direct_control in scenes") return under(ph::direct_control());
  if (law == "saturated_direct_control in scenes") return under(ph::saturated_direct_control());
  if (law == "recommended in scenes") return under(ph::recommended_law(mechanism, given.brakes));
  return false;
}

}  // namespace
}  // namespace reference

bool reference::run_scene(const std::string& device, const std::string& law, const std::string& mode,
                          const std::string& in, const std::string& to) {
  if (device == "tendon_two_link") return run_mode(ph::tendon_two_link<double>(), law, mode, in, to);
  if (device == "delta") return run_mode(ph::delta<double>(), law, mode, in, to);
  return false;
}
