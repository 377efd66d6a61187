// The functions that the page calls. Planar vectors have z = 0. engine/settings.hpp describes texts of
// settings. If a function returns 0, null or false, error() has the reason.
#include "engine/device.hpp"
#include "engine/map.hpp"
#include "engine/presets.hpp"
#include "engine/replay.hpp"

#include <emscripten/bind.h>

#include <exception>
#include <string>
#include <utility>

namespace {

using namespace explorer;
using emscripten::val;

std::string error_text;
std::string last_error() { return error_text; }

// Calls f; what it throws becomes the text of error().
template <class F>
auto guarded(F&& f) {
  error_text.clear();
  try {
    return f();
  } catch (const std::exception& error) {
    error_text = error.what();
  }
  return decltype(f())();
}

// Numbers in the memory of the engine, valid until the next call, because memory may grow.
val view(const double* first, std::size_t count) { return val(emscripten::typed_memory_view(count, first)); }

// The numbers that a member function returns, as a new Float64Array or as an Array.
template <class T, auto Numbers, class... Given>
val copied(T& of, Given... given) {
  const auto numbers = (of.*Numbers)(given...);
  return view(numbers.data(), numbers.size()).template call<val>("slice");
}
template <class T, auto Numbers, class... Given>
val listed(T& of, Given... given) {
  return val::global("Array").call<val>("from", copied<T, Numbers, Given...>(of, given...));
}
val text_of(const char* text) { return val(std::string(text)); }

val object_of(std::initializer_list<std::pair<const char*, val>> members) {
  val made = val::object();
  for (const auto& [name, value] : members) made.set(name, value);
  return made;
}
template <class Elements, class F>
val list_of(const Elements& elements, F&& f) {
  val made = val::array();
  for (const auto& element : elements) made.call<void>("push", f(element));
  return made;
}

val catalogue_of_page() {
  return object_of(
      {{"mechanisms", list_of(mechanisms(),
                              [](const page_mechanism& about) {
                                const auto [n, d, m] =
                                    runtime::find(catalogue().mechanisms(), about.id)->sizes;
                                return object_of({{"id", text_of(about.id)},
                                                  {"label", text_of(about.label)},
                                                  {"joints", val(n)},
                                                  {"dimension", val(d)},
                                                  {"brakes", val(m)}});
                              })},
       {"laws", list_of(catalogue().laws(), [](const runtime::law_entry& law) { return val(law.name); })},
       {"presets", list_of(presets, [](const preset& p) {
          return object_of({{"id", text_of(p.id)},
                            {"title", text_of(p.title)},
                            {"look", text_of(p.look)},
                            {"settings", text_of(p.settings)}});
        })}});
}

template <class T, auto Table>
val columns(T& of) {
  return list_of((of.*Table)().names(), [](const named_value& v) {
    return object_of({{"id", text_of(v.id)},
                      {"label", text_of(v.label)},
                      {"symbol", text_of(v.symbol)},
                      {"equation", text_of(v.equation)},
                      {"unit", val(v.unit)},
                      {"group", text_of(v.group)},
                      {"offset", val(v.offset)},
                      {"size", val(v.size)},
                      {"columns", val(v.columns)},
                      {"words", val::array(v.words)}});
  });
}

// The fields of a device's form; `choices` is empty unless the value is one of several words.
val form_of(device& of) {
  configuration now = of.parts().settings, usual = now.defaults();
  const field_list fields = now.fields(), defaults = usual.fields();
  return list_of(fields, [&](const field& f) {
    std::vector<std::string> choices;
    if (f.type == field::kind::choice)
      for (const auto word : ph::choices_of(f.about)) choices.emplace_back(word);
    return object_of({{"name", val(f.name)},
                      {"group", text_of(f.group)},
                      {"label", text_of(f.about.name)},
                      {"unit", text_of(f.about.unit)},
                      {"value", val(text_of(f))},
                      {"default", val(text_of(defaults[std::size_t(&f - fields.data())]))},
                      {"size", val(f.type == field::kind::numbers ? f.count() : 1)},
                      {"expected", val(f.type == field::kind::numbers ? to_text(f.about.hard) : "")},
                      {"choices", val::array(choices)}});
  });
}

// q, qd, Fh and Fd, which the page may write.
val state_of(device& of) {
  const std::size_t n = std::size_t(of.parts().n());
  const double* at = of.state();
  return object_of({{"q", view(at, n)},
                    {"qd", view(at + n, n)},
                    {"Fh", view(at + 2 * n, 3)},
                    {"Fd", view(at + 2 * n + 3, 3)}});
}
val value_of(device& of, const std::string& id) {
  const auto numbers = of.values().value(id);
  return val::global("Array").call<val>("from", view(numbers.data(), numbers.size()));
}
std::string settings_text(device& of) { return of.changed().text(); }
bool evaluate_at_state(device& of) {
  return guarded([&] { return of.evaluate(), true; });
}
val walls_of(device& of, const place& low, const place& high) {
  const auto points = of.parts().wall.surface(low, high);
  return view(points.data(), points.size()).call<val>("slice");
}

configuration settings_of(const std::string& text) { return make_device(settings(text)).parts().settings; }
template <class T>
bool set(T& of, const std::string& text) {
  return guarded([&] { return of.set(settings(text)), true; });
}

device* new_device(const std::string& text) {
  return guarded([&] { return new device(settings_of(text)); });
}
simulation* new_simulation(const std::string& text) {
  return guarded([&] { return new simulation(settings_of(text)); });
}
replayed_log* open_log(const std::string& text, const std::string& log) {
  return guarded([&] { return new replayed_log(device_parts(settings_of(text)), log); });
}
figure_map* new_map(device& of, int columns, int rows, const place& low, const place& high) {
  return guarded([&] { return new figure_map(of.parts().settings, columns, rows, low, high); });
}

}  // namespace

EMSCRIPTEN_BINDINGS(explorer) {
  using emscripten::allow_raw_pointers;
  using emscripten::class_;
  using emscripten::function;
  using emscripten::index;

  emscripten::value_array<place>("place").element(index<0>()).element(index<1>()).element(index<2>());
  function("error", &last_error);
  function("catalogue", &catalogue_of_page);
  function("new_device", &new_device, allow_raw_pointers());
  function("new_simulation", &new_simulation, allow_raw_pointers());
  function("open_log", &open_log, allow_raw_pointers());

  class_<device>("device")
      .function("columns", &columns<device, &device::values>)
      .function("set", &set<device>)
      .function("settings", &settings_text)
      .function("form", &form_of)
      .function("state", &state_of)
      .function("reach", &device::reach)
      .function("move", &device::move)
      .function("evaluate", &evaluate_at_state)
      .function("value", &value_of)
      .function("drawing", &copied<device, &device::draw>)
      .function("bounds", &listed<device, &device::bounds>)
      .function("outline", &copied<device, &device::outline, int>)
      .function("locus", &copied<device, &device::locus, int, double>)
      .function("walls", &walls_of)
      .function("new_map", &new_map, allow_raw_pointers());
  class_<figure_map>("figure_map")
      .function("advance", &figure_map::advance)
      .function("figure", &copied<figure_map, &figure_map::figure, int>);
  class_<simulation>("simulation")
      .function("columns", &columns<simulation, &simulation::row>)
      .function("set", &set<simulation>)
      .function("step", &simulation::step)
      .function("restart", &simulation::restart)
      .function("rows", &copied<simulation, &simulation::rows>)
      .function("figures", &listed<simulation, &simulation::figures>)
      .function("record", &simulation::record)
      .function("log", &simulation::log);
  class_<replayed_log>("replayed_log")
      .function("columns", &columns<replayed_log, &replayed_log::row>)
      .function("rows", &copied<replayed_log, &replayed_log::rows>)
      .function("agreement", &listed<replayed_log, &replayed_log::agreement>);
}
