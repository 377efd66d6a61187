#include "scene_bench.hpp"

namespace experiments {

scene_bench planar_bench() { return bench_of_all(planar_scene_device()); }

}  // namespace experiments
