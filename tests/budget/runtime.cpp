// Cycles behind runtime/: the paper's device at a plane, and in a world of one.
#include "counted.hpp"

#include <passive_haptics/runtime/catalogue.hpp>

#include <memory>
#include <span>

namespace {

using namespace budget;
namespace rt = ph::runtime;
using tendon = ph::tendon_two_link<double>;

// Everything lies behind the wall
const ph::wall<ph::half_space<2>> wall(ph::half_space<2>({10, 0}, {1, 0}), 1e3);

template <class Scene>
row cycles_in(const Scene& scene) {
  constexpr rt::named_law<ph::direct_control> law{"direct_control"};
  rt::catalogue all;
  all.add_laws(law);
  all.compile_for<tendon>(law);
  const rt::mechanism_model<tendon> mechanism{tendon()};
  const std::shared_ptr<rt::any_controller> control = all.make_controller(
      mechanism, all.laws()[0], {rt::brake_numbers(2), rt::any_scene<2>(scene), all.laws()[0].defaults});
  return [states = random_states(tendon()), control] {
    for (const auto& s : states) {
      const auto span = [](const auto& v) { return std::span<const double>(v.data(), 2); };
      use((*control)({s.time, span(s.q), span(s.qd), span(s.hand_force)}));
    }
  };
}

}  // namespace

int main(int argc, char** argv) {
  rows_by_name rows;
  rows["runtime/plane"] = [] { return cycles_in(ph::scene(wall)); };
  rows["runtime/world"] = [] {
    ph::world_walls<2> walls;
    walls.add(wall);
    return cycles_in(ph::world<2>(walls));
  };
  return run(rows, argc, argv);
}
