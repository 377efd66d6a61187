// What callgrind counts of the ladder: one rung a run, in contact or in free space. Without an argument it lists them.
#include "ladder/rungs.hpp"

#include <cstdio>

constexpr int rounds = 100;

extern "C" [[gnu::noinline]] void counted(const ladder::row& pass) {
  for (int k = 0; k < rounds; ++k) pass();
}

int main(int argc, char** argv) {
  using ladder::place;
  for (const auto& rung : ladder::rungs()) {
    for (const auto& [where, name] : {std::pair{place::contact, "contact"}, {place::free, "free"}}) {
      const std::string row = "ladder/" + rung.name + "/" + name;
      if (argc == 1) std::printf("%s\n", row.c_str());
      if (argc != 2 || row != argv[1]) continue;
      counted(rung.make(where));
      std::printf("cycles: %d\n", ladder::inputs * rounds);
      return 0;
    }
  }
  return argc == 1 ? 0 : 2;
}
