/// All headers for a device's control cycle. Requires only Eigen, Boost.Hana and the standard library. The
/// simulated device has its own headers: passive_haptics/plant/wall_following.hpp.
#pragma once

#include <passive_haptics/core/parameter_text.hpp>
#include <passive_haptics/core/version.hpp>

#include <passive_haptics/mechanism/adaptors/braked_joints.hpp>
#include <passive_haptics/mechanism/chains/denavit_hartenberg.hpp>
#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>
#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>

#include <passive_haptics/brake/at_rest/hand_torque_at_rest.hpp>
#include <passive_haptics/brake/models/encoder_axes.hpp>
#include <passive_haptics/brake/models/rate_limited_brakes.hpp>
#include <passive_haptics/brake/models/switchable_brakes.hpp>
#include <passive_haptics/brake/reference_forces.hpp>

#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/mesh/height_field.hpp>
#include <passive_haptics/scene/mesh/mesh_plausibility.hpp>
#include <passive_haptics/scene/mesh/mesh_solid.hpp>
#include <passive_haptics/scene/mesh/mesh_surface.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/box.hpp>
#include <passive_haptics/scene/shapes/capsule.hpp>
#include <passive_haptics/scene/shapes/complement.hpp>
#include <passive_haptics/scene/shapes/convex_polygon.hpp>
#include <passive_haptics/scene/shapes/convex_polytope.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/scene/shapes/moving.hpp>
#include <passive_haptics/scene/shapes/offset.hpp>
#include <passive_haptics/scene/shapes/virtual_fixtures.hpp>
#include <passive_haptics/scene/shapes/walls_of.hpp>
#include <passive_haptics/scene/world/scene_exchange.hpp>
#include <passive_haptics/scene/world/world.hpp>

#include <passive_haptics/force/effects/detents.hpp>
#include <passive_haptics/force/effects/end_stops.hpp>
#include <passive_haptics/force/effects/guide.hpp>
#include <passive_haptics/force/effects/rough_walls.hpp>
#include <passive_haptics/force/effects/viscous_field.hpp>
#include <passive_haptics/force/effects/wall_friction.hpp>

#include <passive_haptics/control/batch_results.hpp>
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/laws/on_off_control.hpp>
#include <passive_haptics/control/laws/recommended_law.hpp>
#include <passive_haptics/control/laws/saturated_direct_control.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/control/pipelines/several_walls.hpp>
#include <passive_haptics/control/pipelines/with_effects.hpp>
#include <passive_haptics/control/sensorless/sensorless_controller.hpp>
#include <passive_haptics/control/sensorless/torques_at_rest.hpp>

#include <passive_haptics/design/braked_wall_at.hpp>
#include <passive_haptics/design/description.hpp>
#include <passive_haptics/design/fme_boundary.hpp>
#include <passive_haptics/design/min_motor_share.hpp>
#include <passive_haptics/design/plausibility.hpp>
#include <passive_haptics/design/recorded_motion.hpp>
#include <passive_haptics/design/sink_depth.hpp>
#include <passive_haptics/design/undisplayable_share.hpp>

#include <passive_haptics/plant/simulated_device_declaration.hpp>
