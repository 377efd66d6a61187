#include "prelude.hpp"

#ifdef shape_without_a_wall
// error: passive_haptics: a scene consists of walls: put each shape into one, `scene(wall(shape, stiffness))`
const auto scene = ph::scene(ph::wall(plane), plane);
#endif

#ifdef wall_without_a_scene
// error: passive_haptics: a controller needs a scene: `scene(wall(shape, stiffness))`
void cycle() { run(device(), ph::brakes_of<device>(), ph::wall(plane), ph::direct_control()); }
#endif

#ifdef wall_with_the_stiffness_first
// error: passive_haptics: the arguments of a wall are (shape, stiffness), in this order
ph::wall wall(1e5, plane);
#endif

#ifdef ball_with_the_radius_first
// error: passive_haptics: the arguments of a ball are (centre, radius), in this order
ph::disc ball(0.01, {0, 1});
#endif

#ifdef shape_without_a_gradient
// error: passive_haptics: a wall needs a Shape
struct blob {
  static constexpr int dimension = 2;
  double distance(const V2& x) const { return x.norm() - 1; }
};
ph::wall wall{blob()};
#endif

#ifdef polygon_of_two_corners
// error: passive_haptics: a convex_polygon has three corners or more
#include <passive_haptics/scene/shapes/convex_polygon.hpp>
ph::convex_polygon<2> line({{{0, 0}, {1, 0}}});
#endif

#ifdef mesh_surface_in_a_scene
// error: passive_haptics: a shape that is followed (TrackedShape) needs a world
const ph::mesh_surface<2> line(ph::polyline({{{0, 0}, {1, 0}}, {{0, 1}}}));
const auto scene = ph::scene(ph::wall(line));
#endif

#ifdef walls_of_two_dimensions
// error: passive_haptics: all walls of a scene need the same dimension
const auto scene = ph::scene(ph::wall(plane), ph::wall(ph::ball<3>({0, 0, 0}, 1)));
#endif

#ifdef scene_of_another_dimension
// error: passive_haptics: the scene's dimension must be the mechanism's task_dimension
const ph::wall ball(ph::ball<3>({0, 0, 0}, 1));
void cycle() { run(table(), ph::brakes_of<table>(), ph::scene(ball), ph::no_direct_control()); }
#endif

#ifdef world_of_another_dimension
// error: passive_haptics: all walls of a world need the world's dimension.
void fill(ph::world_walls<3>& walls) { walls.add(ph::wall(plane)); }
#endif

#ifdef wall_number_out_of_range
// error: passive_haptics: the scene has no wall with this number
const auto second = ph::scene(ph::wall(plane)).get<1>();
#endif
