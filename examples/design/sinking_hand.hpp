// How steeply and how deep a hand sinks where the brakes of the paper's device cannot display a wall, and
// what motors beside these brakes would buy.
#pragma once

#include <filesystem>

namespace design {

// A picture of the sink slope at each place that the handle can reach, along walls y = const below which it
// is.
void draw_sink_slopes(const std::filesystem::path& directory);

// A table and a picture of the way along the wall of the paper: depths without motors, and the motors that
// would hold the hand.
void compare_motors(const std::filesystem::path& directory);

}  // namespace design
