#include <catalogue/catalogue.hpp>
#include <catalogue/entries.hpp>
#include <catalogue/laws.hpp>
#include <catalogue/mechanisms.hpp>

#include <tuple>

namespace example {
namespace {

ph::runtime::catalogue filled() {
  ph::runtime::catalogue all;
  for_each_mechanism([&]<class M, class P>(const std::string& name) { all.add_mechanism<M, P>(name); });
  std::apply([&](const auto&... law) { all.add_laws(law...); }, laws);
  add_shapes(all);
  add_effects(all);
  add_brake_models(all);
#ifdef PASSIVE_HAPTICS_URDF
  add_urdf_reader(all);
#endif
  compile_all_kinds(all);
  return all;
}

}  // namespace

ph::runtime::catalogue& catalogue() {
  static ph::runtime::catalogue all = filled();
  return all;
}

}  // namespace example
