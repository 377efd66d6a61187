// benchmarks/run latency --worst-case [STATES [DEVICE...]]: the slowest state of each device under each law,
// in instructions, next to the mean. A custom device is one line in of_two_brakes.cpp. Every instruction of a
// cycle is counted, of every state: assembler/ adds the counting to the compiler's code.
#include "devices.hpp"

#include <algorithm>
#include <cstdlib>

extern "C" {
std::uint64_t counted_instructions = 0, uncounted_calls = 0, counted_saved = 0;
}

int main(int argc, char** argv) {
  using worst_case::device;
  auto& all = worst_case::devices();
  std::sort(all.begin(), all.end(), [](const device& a, const device& b) { return a.name < b.name; });
  if (all.empty()) {
    std::printf("summary: skipped: instructions are counted on x86-64 alone\n");
    return 0;
  }
  char* end = nullptr;
  const double states = argc > 1 ? std::strtod(argv[1], &end) : 20000;
  const auto is_chosen = [&](const std::string& name) {
    return argc < 3 || std::find(argv + 2, argv + argc, name) != argv + argc;
  };
  const auto names_device = [&](const std::string& name) {
    return std::any_of(all.begin(), all.end(), [&](const device& one) { return one.name == name; });
  };
  if ((argc > 1 && *end != '\0') || !(states >= 2 && states <= 1e12) ||
      !std::all_of(argv + std::min(argc, 2), argv + argc, names_device)) {
    std::fprintf(
        stderr,
        "usage: latency --worst-case [STATES [DEVICE...]], 2 to 1e12 states each (20000), of the devices\n");
    for (const device& one : all) std::fprintf(stderr, "  %s\n", one.name.c_str());
    return 2;
  }
  std::printf("Instructions of one control cycle, %.0f states each, seed %u\n", states, worst_case::seed);
  std::printf("%-24s %5s  %-26s %8s %9s %9s\n%-24s %5s  %-26s %8s %9s %9s\n", "", "", "", "ordinary",
              "ordinary", "hard", "device", "walls", "law", "mean", "worst", "worst");
  for (const device& one : all)
    if (is_chosen(one.name)) one.print(static_cast<long>(states));
}
