// The ladder's table.
#include "parts.hpp"
#include "rungs.hpp"

#include <cstdio>
#include <string>

namespace scenes {

namespace {
std::string row_of(const ladder::rung& rung, const char* place) {
  return "ladder/" + rung.name + "/" + place;
}
}  // namespace

void add_ladder() {
  using ladder::place;
  for (const auto& rung : ladder::rungs()) {
    for (const auto& [where, name] : {std::pair{place::contact, "contact"}, std::pair{place::free, "free"}}) {
      benchmark::RegisterBenchmark(row_of(rung, name).c_str(),
                                   [pass = rung.make(where)](benchmark::State& run) {
                                     while (run.KeepRunningBatch(ladder::inputs)) pass();
                                   });
    }
  }
}

std::string print_ladder(const benchmarks::results& all) {
  const auto time = [&](const ladder::rung& rung, const char* place) {
    return all.at(row_of(rung, place)).cpu_time;
  };
  for (const auto& rung : ladder::rungs())
    if (!all.contains(row_of(rung, "contact")) || !all.contains(row_of(rung, "free"))) return {};
  std::printf("One control cycle [ns of CPU time]: each rung has one need more than the one above it\n");
  std::printf("%-42s %9s %6s %7s %6s\n", "", "contact", "more", "free", "more");
  const auto rungs = ladder::rungs();
  for (std::size_t k = 0; k < rungs.size(); ++k) {
    std::printf("%-42s", rungs[k].adds.c_str());
    for (const char* place : {"contact", "free"}) {
      std::printf(" %7.1f", time(rungs[k], place));
      if (k == 0) std::printf(" %8s", "");
      else std::printf(" %8.1f", time(rungs[k], place) - time(rungs[k - 1], place));
    }
    std::printf("\n");
  }
  char text[160];
  std::snprintf(text, sizeof text, "ladder: the smallest scene in contact %.1f ns, %.2fx of by hand",
                time(rungs[1], "contact"), time(rungs[1], "contact") / time(rungs[0], "contact"));
  return text;
}

}  // namespace scenes
