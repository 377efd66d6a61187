// reference DEVICE LAW MODE STATES RESULTS: runs the cycles of a file and writes what they decide. LAW may be
// "design", for the figures of the device and runs along a wall, "log", or "direct_control in scenes", for
// cycles in a scene, MODE, whose shapes stand in the file STATES.shapes.
#include "reference.hpp"

#include <cstdio>

int main(int count, char** words) {
  if (count != 6) {
    std::fprintf(stderr, "usage: %s DEVICE LAW cycle|batch|figures|depth|runs|write|SCENE STATES RESULTS\n",
                 words[0]);
    return 2;
  }
  const std::string device = words[1], law = words[2], mode = words[3], in = words[4], to = words[5];
  for (const auto run_any :
       {reference::run_device, reference::run_design, reference::run_log, reference::run_scene})
    if (run_any(device, law, mode, in, to)) return 0;
  std::fprintf(stderr, "%s under %s is not compiled in\n", device.c_str(), law.c_str());
  return 2;
}
