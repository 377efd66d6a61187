/// @file
/// Points and vectors of the task, with z = 0 in the plane.
#pragma once

#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/runtime/cycle_record.hpp>

#include <span>
#include <vector>

namespace explorer {

namespace ph = passive_haptics;
namespace runtime = passive_haptics::runtime;

using place = ph::vector<double, 3>;  ///< [m], [m/s] or [N], base frame.

/// The d numbers of a record.
inline place place_of(const runtime::task_numbers& x) { return place(x.values.data()); }
/// The first numbers of a setting.
inline place place_of(const std::vector<double>& x) { return {x[0], x[1], x.size() > 2 ? x[2] : 0.0}; }
/// The first d components.
inline std::span<const double> first(const place& x, int d) { return {x.data(), std::size_t(d)}; }

}  // namespace explorer
