#include "scene_bench.hpp"

namespace experiments {

scene_bench spatial_bench() {
  using delta = ph::delta<double>;
  const delta robot;
  return bench_of_all<delta>(
      {"delta", robot, {{0, 0, -0.14}, {0, 0, 1}, {1, 0, 0}}, robot.inverse({0, 0, -0.14}).q});
}

}  // namespace experiments
