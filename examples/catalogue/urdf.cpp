// Chains of URDFs for the mechanisms of the catalogue.
#include <passive_haptics/interop/urdf.hpp>

#include <catalogue/entries.hpp>
#include <catalogue/mechanisms.hpp>

#include <stdexcept>

namespace example {
namespace {

using ph::runtime::urdf_mechanism;

template <int N, int D>
ph::runtime::any_parameters parameters_of(const ph::urdf_chain& chain) {
  const auto made = ph::chain_of<N, D>(chain);
  return ph::runtime::any_parameters(heavy_chain_parameters<N, D>{made.parameters(), made.inertia()});
}

struct chain_type {
  const char* name;
  int joints, dimension;
  ph::runtime::any_parameters (*parameters)(const ph::urdf_chain&);
};
// Those of for_each_mechanism
constexpr chain_type types[] = {
    {"planar_chain_2_with_inertia", 2, 2, parameters_of<2, 2>},
    {"planar_chain_3_with_inertia", 3, 2, parameters_of<3, 2>},
    {"planar_chain_4_with_inertia", 4, 2, parameters_of<4, 2>},
    {"spatial_chain_3_with_inertia", 3, 3, parameters_of<3, 3>},
    {"spatial_chain_6_with_inertia", 6, 3, parameters_of<6, 3>},
    {"spatial_chain_7_with_inertia", 7, 3, parameters_of<7, 3>},
};

urdf_mechanism read(const ph::runtime::urdf_source& from, const std::string& name) {
  ph::urdf_options options;
  options.tool = from.tool;
  options.inertia = from.balanced ? ph::urdf_inertia::balanced : ph::urdf_inertia::as_given;
  const ph::urdf_chain chain = ph::read_urdf(from.urdf, from.base, from.tip, options);
  // Three joints are the only number with a choice
  const bool is_planar = chain.joints.size() != 3 || ph::plane_of(chain).error.empty();
  std::string possible;
  for (const chain_type& type : types) {
    if (std::ssize(chain.joints) != type.joints) continue;
    if (name == type.name || (name.empty() && (type.dimension == 3 || is_planar)))
      return {type.name, type.parameters(chain), chain.remarks};
    possible.append(possible.empty() ? "" : " or ").append(type.name);
  }
  if (possible.empty())
    throw std::invalid_argument("passive_haptics: " + chain.name +
                                ": moving joints = " + std::to_string(chain.joints.size()) +
                                ": expected 2 to 4 in one plane, or 3, 6 or 7 in space; choose other links");
  throw std::invalid_argument("passive_haptics: type = \"" + name + "\": expected " + possible +
                              ", which has as many joints as " + chain.name);
}

}  // namespace

void add_urdf_reader(ph::runtime::catalogue& all) { all.add_urdf_reader(read); }

}  // namespace example
