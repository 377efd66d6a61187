// Do the tests notice a mistake? One line of the library is changed at a time, and the tests are run.
#include "generator/draw.hpp"
#include "runner/campaign.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace {

using namespace mutants;

options options_of(int argc, char** argv) {
  options o;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i], value = i + 1 < argc ? argv[i + 1] : "";
    if (name == "--again") {
      o.again = true;
      continue;
    }
    if (name == "--argued") {
      o.argued = true;
      continue;
    }
    if (name == "--of") o.of = value;
    else if (name == "--seed") o.seed = std::stoull(value);
    else if (name == "--count") o.count = std::stoul(value);
    else if (name == "--jobs") o.jobs = static_cast<unsigned>(std::stoul(value));
    else {
      std::cerr << "usage: mutants [--of REGEX] [--seed S] [--count N] [--jobs J] [--again] [--argued], in "
                   "the repository\n"
                   "--of: those alone whose 'file | operator' it finds, as 'force/' or 'scene/.*clamp'\n"
                   "--again: what was killed before need not be killed again\n"
                   "--argued: those alone that tests/mutants/equivalent.txt argues about\n";
      std::exit(name == "--help" ? 0 : 2);
    }
    ++i;
  }
  return o;
}

}  // namespace

int main(int argc, char** argv) {
  const options o = options_of(argc, argv);
  fs::create_directories(o.work);
  const sources headers = read_headers(o.repository);
  const std::vector<mutant> all = all_mutants(headers);
  const auto argued = keys_in(read_text(o.repository / "tests/mutants/equivalent.txt"));
  for (const auto& [key, why] : stale(argued, all)) {
    std::cerr << "error: tests/mutants/equivalent.txt argues about what is no longer there: " << key << '\n';
    return 2;
  }
  const auto is_argued = [&](const mutant& m) { return argued.contains(key_of(m)); };
  const double argued_share =
      100.0 * static_cast<double>(std::ranges::count_if(all, is_argued)) / static_cast<double>(all.size());
  std::vector<mutant> some = those_of(all, o.of);
  std::erase_if(some, [&](const mutant& m) { return is_argued(m) != o.argued; });
  std::cout << "seed " << o.seed << ", " << o.count << " of " << some.size() << " mutants"
            << (o.argued ? " that are argued to change nothing: each must survive\n" : "\n") << std::flush;
  campaign one(o, headers, drawn(some, o.seed, o.count * 3 / 2));  // some will not compile
  const double killed = print_table(std::cout, one.judge(), o.argued);
  if (o.argued) return killed > 0 ? 1 : 0;
  std::cout << argued_share << " % of all " << all.size()
            << " mutants are argued to change nothing: of those none is drawn\n";
  return killed >= 97 && argued_share <= 3 ? 0 : 1;
}
