#include "device.hpp"
#include "laws.hpp"
#include "presets.hpp"

#include <passive_haptics/core/version.hpp>

namespace explorer {
namespace {

// A figure of a design map.
struct figure_description {
  const char *id, *label, *symbol, *unit, *look;
};

// In the order of map_of.
constexpr figure_description figures[] = {
    {"cosine", "cosine of the approximation angle", "cos γ", "1",
     "1: the wall's force can be made exactly; 0: nothing against the wall."},
    {"drag", "drag", "", "1", "Force against the motion for each newton out of the wall."},
    {"max_force", "strongest force", "", "N", "The most that the brakes make against the wall."},
    {"sink_slope", "sink slope", "", "1", "Metres into the wall for each metre along it."},
    {"isotropy", "isotropy", "", "1", "1: the brakes serve all directions alike; 0: a singular pose."},
    {"display", "class", "", "", "0 not displayed, 1 approximate, 2 exact."}};

// A kind of scene.
struct scene_description {
  const char *id, *label;
  bool plane, space;
};
constexpr scene_description scenes[] = {{"none", "No wall", true, true},
                                        {"plane", "Plane", true, true},
                                        {"solid", "Circle or ball from outside", true, true},
                                        {"hollow", "Circle or ball from inside", true, true},
                                        {"edge", "Edge", true, false},
                                        {"outline", "Outline of a body", true, false},
                                        {"box", "Box", false, true}};

}  // namespace

const std::vector<mechanism_entry>& mechanisms() {
  static const std::vector<mechanism_entry> all = {
      tendon_two_link_entry(), two_link_entry(),  xy_table_entry(), five_bar_entry(),
      five_bar_4_entry(),      planar_3r_entry(), delta_entry(),    spatial_3r_entry()};
  return all;
}

std::unique_ptr<device> make_device(const settings& given) {
  const std::string* id = given.find("mechanism");
  std::string known;
  for (const mechanism_entry& e : mechanisms()) {
    if (id != nullptr && *id == e.id) {
      std::unique_ptr<device> made = e.make();
      made->set(given);
      return made;
    }
    known.append(known.empty() ? "one of " : ", ").append(e.id);
  }
  refuse("mechanism", id == nullptr ? "" : *id, known);
}

std::string catalogue() {
  json_writer json;
  json.object([&] {
    json.put("version", 1);
    json.put("library", std::to_string(PASSIVE_HAPTICS_VERSION_MAJOR) + "." +
                            std::to_string(PASSIVE_HAPTICS_VERSION_MINOR) + "." +
                            std::to_string(PASSIVE_HAPTICS_VERSION_PATCH));
    const auto list = [&](const char* name, const auto& all, const auto& write) {
      json.name(name);
      json.list([&] {
        for (const auto& x : all) json.object([&] { write(x); });
      });
    };
    list("mechanisms", mechanisms(), [&](const mechanism_entry& e) {
      json.put("id", e.id);
      json.put("label", e.label);
      json.put("joints", e.joints);
      json.put("dimension", e.dimension);
      json.put("brakes", e.brakes);
      json.put("has_branches", e.has_branches);
    });
    list("laws", laws, [&](const law_description& l) {
      json.put("id", l.id);
      json.put("look", l.look);
      json.put("equation", l.equation);
    });
    list("scenes", scenes, [&](const scene_description& s) {
      json.put("id", s.id);
      json.put("label", s.label);
      json.put_list("dimensions", s.plane && s.space ? std::vector{2, 3} : std::vector{s.plane ? 2 : 3});
    });
    list("figures", figures, [&](const figure_description& f) {
      json.put("id", f.id);
      json.put("label", f.label);
      json.put("symbol", f.symbol);
      json.put("unit", f.unit);
      json.put("look", f.look);
    });
    list("presets", presets, [&](const preset& p) {
      json.put("id", p.id);
      json.put("title", p.title);
      json.put("look", p.look);
      json.put("settings", p.settings);
    });
  });
  return json.text();
}

}  // namespace explorer
