/// @file
/// What nearly every source includes of other libraries and of passive_haptics: setup.py compiles it once.
/// A source that includes it does so first.
#pragma once

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <passive_haptics/brake/models/switchable_brakes.hpp>
#include <passive_haptics/control/batch/batch_controller.hpp>
#include <passive_haptics/control/laws/recommended_law.hpp>
#include <passive_haptics/control/laws/saturated_direct_control.hpp>
#include <passive_haptics/control/pipelines/several_walls.hpp>
#include <passive_haptics/control/pipelines/with_effects.hpp>
#include <passive_haptics/design/braked_wall_at.hpp>
#include <passive_haptics/design/fme_boundary.hpp>
#include <passive_haptics/design/map/design_figures.hpp>
#include <passive_haptics/design/sink_depth.hpp>
#include <passive_haptics/force/nearest_force.hpp>
#include <passive_haptics/plant/wall_following.hpp>
#include <passive_haptics/scene/scene.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/scene/world/world.hpp>
