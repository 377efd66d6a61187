/// @file
/// What the descriptions of arms share: how they are drawn.
#pragma once

#include "../device_of.hpp"

#include <span>

namespace explorer {

/// Radius in which a brake is drawn, of the longest length of a device [1].
inline constexpr double brake_share = 0.13;

/// Links from the base over the joints to the handle, the last of `points`.
inline void draw_links(drawing& to, std::span<const drawing::place> points, double size) {
  to.add(item_kind::ground, -1, points.front(), points.front(), size);
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    to.add(item_kind::link, int(i), points[i], points[i + 1]);
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    to.add_turning(item_kind::joint, int(i), points[i], out_of_plane());
  to.add(item_kind::handle, -1, points.back(), points.back());
}

}  // namespace explorer
