// What callgrind counts of the ladder of benchmarks/scenes: one rung a run, in contact or in free space.
// Without an argument it lists the rows.
#include "../../benchmarks/scenes/rungs.hpp"

#include <cstdio>
#include <string>

namespace {
constexpr int rounds = 100;
}

extern "C" [[gnu::noinline]] void counted(const ladder::row& pass) {
  for (int k = 0; k < rounds; ++k) pass();
}

int main(int argc, char** argv) {
  using ladder::place;
  const std::string chosen = argc == 2 ? argv[1] : "";
  for (const auto& rung : ladder::rungs()) {
    for (const auto& [where, name] : {std::pair{place::contact, "contact"}, std::pair{place::free, "free"}}) {
      const std::string row = "ladder/" + rung.name + "/" + name;
      if (chosen.empty()) std::printf("%s\n", row.c_str());
      if (row != chosen) continue;
      counted(rung.make(where));
      std::printf("cycles: %d\n", ladder::inputs * rounds);
      return 0;
    }
  }
  return chosen.empty() ? 0 : 2;
}
