/// @file
/// Everything that a device's control cycle is made of; needs no more than Eigen, Boost.Hana and the standard library.
/// The simulated device of plant/ is included by itself: passive_haptics/plant/wall_following.hpp.
#pragma once

#include <passive_haptics/core/version.hpp>

#include <passive_haptics/mechanism/delta.hpp>
#include <passive_haptics/mechanism/denavit_hartenberg.hpp>
#include <passive_haptics/mechanism/five_bar.hpp>
#include <passive_haptics/mechanism/serial_chain_with_inertia.hpp>
#include <passive_haptics/mechanism/tendon_two_link.hpp>
#include <passive_haptics/mechanism/two_link.hpp>
#include <passive_haptics/mechanism/xy_table.hpp>

#include <passive_haptics/brake/encoder_axes.hpp>
#include <passive_haptics/brake/fme_boundary.hpp>
#include <passive_haptics/brake/reference_forces.hpp>

#include <passive_haptics/scene/ball.hpp>
#include <passive_haptics/scene/box.hpp>
#include <passive_haptics/scene/capsule.hpp>
#include <passive_haptics/scene/complement.hpp>
#include <passive_haptics/scene/convex_polygon.hpp>
#include <passive_haptics/scene/convex_polytope.hpp>
#include <passive_haptics/scene/half_space.hpp>
#include <passive_haptics/scene/height_field.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/mesh_solid.hpp>
#include <passive_haptics/scene/mesh_surface.hpp>
#include <passive_haptics/scene/moving.hpp>
#include <passive_haptics/scene/offset.hpp>
#include <passive_haptics/scene/room.hpp>
#include <passive_haptics/scene/scene_exchange.hpp>
#include <passive_haptics/scene/virtual_fixtures.hpp>
#include <passive_haptics/scene/world.hpp>

#include <passive_haptics/force/effects/detents.hpp>
#include <passive_haptics/force/effects/end_stops.hpp>
#include <passive_haptics/force/effects/guide.hpp>
#include <passive_haptics/force/effects/viscous_field.hpp>
#include <passive_haptics/force/effects/wall_friction.hpp>

#include <passive_haptics/control/coercive_force_approximation.hpp>
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/laws.hpp>
#include <passive_haptics/control/on_off_control.hpp>
#include <passive_haptics/control/sensorless_controller.hpp>
#include <passive_haptics/control/single_degree_of_freedom_control.hpp>
#include <passive_haptics/control/velocity_direct_control.hpp>
#include <passive_haptics/control/velocity_ratio_control.hpp>
