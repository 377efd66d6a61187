// Sink slopes and depths of a hand if the brakes of the paper's device cannot display a wall, and the benefit
// of additional motors.
#pragma once

#include <filesystem>

namespace design {

// A picture of the sink slope at each reachable place, along walls y = const above the handle.
void draw_sink_slopes(const std::filesystem::path& directory);

// A table and a picture along the paper's wall: depths without motors, and the motors that hold the hand.
void compare_motors(const std::filesystem::path& directory);

}  // namespace design
