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
  const char *arm, *forces;
  bool settles;
  std::function<felt_row()> feel;
};

// The cases of an arm; kinetostatic forces are for brakes on all joints.
template <class M>
void add_cases(std::vector<felt_case>& cases, const char* name, const M& arm) {
  cases.push_back({name, "settled", true, [=] { return feel(arm, arm, states); }});
  cases.push_back({name, "inertial", false, [=] { return feel(arm, ph::inertial(arm), states); }});
  if constexpr (M::brake_count == M::dof)
    cases.push_back({name, "kinetostatic", false, [=] { return feel(arm, ph::kinetostatic(arm), states); }});
}

}  // namespace

std::string felt_forces() {
  std::vector<felt_case> cases;
  const auto three = planar_rods<3>({0.15, 0.15, 0.1});
  add_cases(cases, "3R", three);
  add_cases(cases, "3R, brakes 1 and 2", with_brakes<0, 1>(three));
  add_cases(cases, "4R", planar_rods<4>({0.12, 0.12, 0.1, 0.08}));
  const auto rows = on_all_cores("felt forces", cases.size(), [&](std::size_t k) { return cases[k].feel(); });
  std::string table = markdown_head({"arm", "forces", "displayed", "median felt [N]", "within 10 %",
                                     "others: sign not known / not at rest / pose has changed"});
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const felt_row& r = rows[k];
    const std::string others =
        cases[k].settles ? written("%zu / %zu / %zu", r.unknown_sign, r.not_at_rest, r.pose) : "";
    table += markdown_row({cases[k].arm, cases[k].forces, written("%.0f %%", 100 * r.displayed_share()),
                           written("%.2f", r.median), written("%.0f %%", 100 * r.within_share()), others});
  }
  return table;
}

}  // namespace experiments
