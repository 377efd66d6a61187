// no sanitizers
// Each mechanism of examples/catalogue under each of its laws has the cycles of its own controller.
#include "pairs.hpp"

#include "../../property/chain_cases.hpp"

#include <catalogue/catalogue.hpp>
#include <catalogue/laws.hpp>
#include <catalogue/mechanisms.hpp>

#include <passive_haptics/control/pipelines/one_wall.hpp>

#include <cstdlib>
#include <string_view>
#include <tuple>

namespace {

// What a chain has no default for.
template <class P>
struct parameters {
  static P some() { return {}; }
};
template <int N, int D>
struct parameters<ph::serial_chain_parameters<double, N, D>> {
  static auto some() { return chains::irregular_chain<double, N, D>::geometry(); }
};
template <int N, int D>
struct parameters<example::heavy_chain_parameters<N, D>> {
  static example::heavy_chain_parameters<N, D> some() {
    using chain = chains::irregular_chain<double, N, D>;
    return {chain::geometry(), chain::inertia()};
  }
};

std::size_t cycles() {
  const char* const stress = std::getenv("PASSIVE_HAPTICS_STRESS");
  return stress != nullptr && std::string_view(stress) == "full" ? 10'000 : 200;
}

TEST(catalogue, each_mechanism_has_the_cycles_of_its_own_controller_under_each_law) {
  const rt::catalogue& all = example::catalogue();
  std::size_t pairs = 0;
  example::for_each_mechanism([&]<class M, class P>(const std::string& name) {
    const P given = parameters<P>::some();
    const auto mechanism = rt::find(all.mechanisms(), name)->make(rt::any_parameters(given));
    const auto compare = [&]<class L>(const rt::named_law<L>& law) {
      if constexpr (!ph::needs_dynamics<L> || ph::Dynamics<M>) {
        SCOPED_TRACE(name + " under " + law.name);
        expect_same_cycles<L>(all, *mechanism, law.name, M(given), cycles());
        ++pairs;
      }
    };
    std::apply([&](const auto&... law) { (compare(law), ...); }, example::laws);
  });
  EXPECT_GE(pairs, 84u);
}

}  // namespace
