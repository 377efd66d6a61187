/// @file
/// Which batches are computed several states at a time, and compiled in packs.cpp alone.
#pragma once

#include <passive_haptics_python/controller_of.hpp>

/// A batch of a mechanism under one law.
#define PASSIVE_HAPTICS_PYTHON_PACKED(M, L)                                                             \
  template std::unique_ptr<any_batch> packed_batch<M, L>(const M&, const ph::brakes_of<M>&,             \
                                                         const ph::wall<any_shape<M::task_dimension>>&, \
                                                         const L&, const ph::step_options<double>&);

/// The batches of a mechanism stand in packs.cpp.
#define PASSIVE_HAPTICS_PYTHON_PACKS_ELSEWHERE(M)                                                   \
  extern PASSIVE_HAPTICS_PYTHON_PACKED(M, ph::direct_control) extern PASSIVE_HAPTICS_PYTHON_PACKED( \
      M, ph::saturated_direct_control)
