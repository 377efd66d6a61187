#include "results_page.hpp"

#include <output.hpp>

#include <cstdio>
#include <cstdlib>

namespace experiments {

bool is_printed(const page_tables& tables) {
  example::page_of_tables page(results_page);
  bool all = true;
  for (const auto& [name, table] : tables) {
    const std::string difference = page.difference(name, table);
    if (!difference.empty()) std::printf("docs/results.md, table %s: %s\n", name.c_str(), difference.c_str());
    all = all && difference.empty();
    page.replace(name, table);
  }
  if (std::getenv("PASSIVE_HAPTICS_WRITE_PAGES") == nullptr) return all;
  example::write_file(results_page, page.text());
  return true;
}

}  // namespace experiments
