/// @file
/// The mechanisms of the page: entries of a catalogue, and how each is drawn.
#pragma once

#include "drawing.hpp"

#include <passive_haptics/runtime/catalogue.hpp>

#include <functional>
#include <vector>

namespace explorer {

/// A mechanism in a pose, for its drawing.
struct drawn_pose {
  const runtime::any_mechanism& mechanism;    ///< The mechanism.
  const runtime::any_parameters& parameters;  ///< Its parameters.
  const double* q;                            ///< n [rad or m]
  place handle;                               ///< [m]
};

/// A mechanism as the page shows it.
struct page_mechanism {
  const char* id;             ///< As in the settings and the catalogue.
  const char* label;          ///< In words.
  const char* scene;          ///< The wall at first.
  std::vector<double> start;  ///< Joint positions at first [rad or m].
  bool slides;                ///< Joints slide, not turn.
  std::function<double(const runtime::any_parameters& parameters)>
      reach;                                          ///< Half the size of the box about the base [m].
  void (*draw)(const drawn_pose& pose, drawing& to);  ///< Adds its items.
};

/// All mechanisms, in the order of the page.
const std::vector<page_mechanism>& mechanisms();
/// The mechanisms and laws of the page by name.
const runtime::catalogue& catalogue();

}  // namespace explorer
