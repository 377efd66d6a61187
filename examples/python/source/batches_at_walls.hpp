/// @file
/// Which batches are compiled for their wall, in batches/ alone: there each is one function, as FLATTEN makes
/// it.
#pragma once

#include <passive_haptics_python/controller_of.hpp>

/// The batches of mechanism M under law L: after `extern` in one source, alone in another one.
#define PASSIVE_HAPTICS_PYTHON_BATCH(M, L)                                                               \
  template std::unique_ptr<any_batch> batch_at_wall<M, L>(const M&, const ph::brakes_of<M>&,             \
                                                          const ph::wall<any_shape<M::task_dimension>>&, \
                                                          const L&, const ph::step_options<double>&)

/// Those of mechanism M under its usual laws are compiled for planes.
#define PASSIVE_HAPTICS_PYTHON_COMPILED_FOR_PLANES(M)                                   \
  template <>                                                                           \
  inline constexpr bool is_compiled_for_planes<M, ph::direct_control> = true;           \
  template <>                                                                           \
  inline constexpr bool is_compiled_for_planes<M, ph::saturated_direct_control> = true; \
  template <>                                                                           \
  inline constexpr bool is_compiled_for_planes<M, recommended_law_of<M>> = true

/// They stand elsewhere.
#define PASSIVE_HAPTICS_PYTHON_BATCHES_ELSEWHERE(M)                     \
  PASSIVE_HAPTICS_PYTHON_COMPILED_FOR_PLANES(M);                        \
  extern PASSIVE_HAPTICS_PYTHON_BATCH(M, ph::direct_control);           \
  extern PASSIVE_HAPTICS_PYTHON_BATCH(M, ph::saturated_direct_control); \
  extern PASSIVE_HAPTICS_PYTHON_BATCH(M, recommended_law_of<M>)

/// They stand here.
#define PASSIVE_HAPTICS_PYTHON_BATCHES_HERE(M)                   \
  PASSIVE_HAPTICS_PYTHON_COMPILED_FOR_PLANES(M);                 \
  PASSIVE_HAPTICS_PYTHON_BATCH(M, ph::direct_control);           \
  PASSIVE_HAPTICS_PYTHON_BATCH(M, ph::saturated_direct_control); \
  PASSIVE_HAPTICS_PYTHON_BATCH(M, recommended_law_of<M>)
