// How a cycle's time grows with its scene: need by need (rows ladder/), with 100 000 shapes or triangles
// (large/). One part: benchmarks/run scenes --benchmark_filter=ladder
#include "scenes/parts.hpp"

#include <cstdio>

int main(int argc, char** argv) {
  scenes::add_ladder();
  scenes::add_large_scenes();
  const auto all = benchmarks::run(argc, argv, {"--benchmark_min_time=0.1", "--benchmark_repetitions=5"});
  for (const auto print : {scenes::print_ladder, scenes::print_large_scenes})
    if (const std::string summary = print(all); !summary.empty())
      std::printf("summary: %s\n", summary.c_str());
}
