#include "felt_forces.hpp"

#include "batch.hpp"
#include "felt_force.hpp"
#include "markdown.hpp"
#include "rods.hpp"

#include <functional>
#include <vector>

namespace experiments {

namespace {

constexpr std::size_t states = 300;

struct felt_case {
  const char* arm;
  std::function<felt_row()> feel;
};

template <class M>
felt_case case_of(const char* name, const M& arm) {
  return {name, [=] { return feel(arm, states); }};
}

}  // namespace

std::string felt_forces() {
  const auto three = planar_rods<3>({0.15, 0.15, 0.1});
  const std::vector<felt_case> cases{case_of("3R", three),
                                     case_of("3R, brakes 1 and 2", with_brakes<0, 1>(three)),
                                     case_of("4R", planar_rods<4>({0.12, 0.12, 0.1, 0.08}))};
  const auto rows = on_all_cores("felt forces", cases.size(), [&](std::size_t k) { return cases[k].feel(); });
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
