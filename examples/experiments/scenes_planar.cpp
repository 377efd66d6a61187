#include "scene_run.hpp"

namespace experiments {

scene_bench planar_bench() { return bench_of_all_laws(planar_scene_device()); }

}  // namespace experiments
