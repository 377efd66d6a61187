/// @file
/// Everything that needs no more than Eigen, Boost.Hana and the standard library.
#pragma once

#include <passive_haptics/core/version.hpp>

#include <passive_haptics/mechanism/delta.hpp>
#include <passive_haptics/mechanism/denavit_hartenberg.hpp>
#include <passive_haptics/mechanism/five_bar.hpp>
#include <passive_haptics/mechanism/serial_chain_with_inertia.hpp>
#include <passive_haptics/mechanism/tendon_two_link.hpp>
#include <passive_haptics/mechanism/two_link.hpp>
#include <passive_haptics/mechanism/xy_table.hpp>

#include <passive_haptics/brake/fme_boundary.hpp>
#include <passive_haptics/brake/reference_forces.hpp>

#include <passive_haptics/scene/ball.hpp>
#include <passive_haptics/scene/half_space.hpp>
#include <passive_haptics/scene/held_scene.hpp>

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/laws.hpp>

#include <passive_haptics/plant/wall_following.hpp>
