#include "felt_forces.hpp"

#include "batch.hpp"
#include "markdown.hpp"

#include <array>

namespace experiments {

std::string felt_forces() {
  constexpr std::size_t states = 300;
  struct felt_case {
    const char* arm;
    felt_row (*feel)(std::size_t states);
  };
  constexpr std::array<felt_case, 3> cases{
      {{"3R", feel_3r}, {"3R, brakes 1 and 2", feel_two_brakes}, {"4R", feel_4r}}};
  const auto rows =
      on_all_cores("felt forces", cases.size(), [&](std::size_t k) { return cases[k].feel(states); });
  std::string table = markdown_head({"arm", "displayed", "median felt [N]", "within 10 %",
                                     "others: sign not known / not at rest / pose has changed"});
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const felt_row& r = rows[k];
    table += markdown_row({cases[k].arm, written("%.0f %%", 100 * r.displayed_share()),
                           written("%.2f", r.median), written("%.0f %%", 100 * r.within_share()),
                           written("%zu / %zu / %zu", r.unknown_sign, r.not_at_rest, r.pose)});
  }
  return table;
}

}  // namespace experiments
