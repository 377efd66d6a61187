#include "exports.hpp"

#include "device.hpp"
#include "json.hpp"
#include "map.hpp"
#include "presets.hpp"
#include "replay.hpp"

#include <exception>
#include <memory>
#include <string>
#include <vector>

namespace {

using namespace explorer;

std::string& last_error() {
  static std::string text;
  return text;
}

// Calls f; what it throws becomes the text of explorer_error(), and 0 is returned.
template <class F>
auto guarded(F&& f) {
  last_error().clear();
  try {
    return f();
  } catch (const std::exception& error) {
    last_error() = error.what();
  } catch (...) {
    last_error() = "an unknown error";
  }
  return decltype(f())();
}

// An object with the texts and tables that its functions have returned.
template <class T>
struct handle : T {
  template <class... Given>
  explicit handle(Given&&... given) : T(std::forward<Given>(given)...) {}
  std::string text, layout, form_text;
  std::vector<double> points;
  drawing drawn;
};
using device_handle = handle<device>;
using simulation_handle = handle<simulation>;
using log_handle = handle<replayed_log>;

template <class T>
T& at(void* p) {
  return *static_cast<T*>(p);
}
device_handle& device_at(void* p) { return at<device_handle>(p); }
simulation_handle& simulation_at(void* p) { return at<simulation_handle>(p); }
log_handle& log_at(void* p) { return at<log_handle>(p); }

configuration settings_of(const char* given) { return make_device(settings(given)).parts().settings; }

// Keeps the points that f returns, and returns their number.
template <class F>
int points_of(void* p, F&& f) {
  return guarded([&] {
    device_at(p).points = f(device_at(p));
    return int(device_at(p).points.size() / 3);
  });
}

const char* kept(std::string& place, std::string text) {
  place = std::move(text);
  return place.c_str();
}

template <class Handle>
const char* row_layout(Handle& h, value_table& table) {
  json_writer json;
  json.object([&] {
    json.put("row", table.size());
    json.name("values");
    table.write(json);
  });
  return kept(h.layout, json.text());
}

std::string catalogue_text() {
  json_writer json;
  json.object([&] {
    json.name("mechanisms");
    json.list(mechanisms(), [&](const page_mechanism& about) {
      const auto [n, d, m] = runtime::find(catalogue().mechanisms(), about.id)->sizes;
      json.put("id", about.id);
      json.put("label", about.label);
      json.put("joints", n);
      json.put("dimension", d);
      json.put("brakes", m);
      json.put("has_branches", about.has_branches ? 1 : 0);
    });
    json.name("laws");
    json.list(catalogue().laws(), [&](const runtime::law_entry& law) { json.put("id", law.name); });
    json.name("presets");
    json.list(presets, [&](const preset& p) {
      json.put("id", p.id);
      json.put("title", p.title);
      json.put("look", p.look);
      json.put("settings", p.settings);
    });
  });
  return json.text();
}

}  // namespace

extern "C" {

const char* explorer_catalogue() {
  static std::string text;
  return kept(text, catalogue_text());
}
const char* explorer_error() { return last_error().c_str(); }

void* explorer_new(const char* given) {
  return guarded([&]() -> void* { return new device_handle(settings_of(given)); });
}
void explorer_delete(void* p) { delete &device_at(p); }
int explorer_set(void* p, const char* given) {
  return guarded([&] { return device_at(p).set(settings(given)), 1; });
}
const char* explorer_settings(void* p) { return kept(device_at(p).text, device_at(p).changed().text()); }
const char* explorer_form(void* p) { return kept(device_at(p).form_text, device_at(p).form()); }
double* explorer_state(void* p) { return device_at(p).state(); }
int explorer_reach(void* p, double x, double y, double z) { return device_at(p).reach({x, y, z}) ? 1 : 0; }
void explorer_move(void* p, double vx, double vy, double vz) { device_at(p).move({vx, vy, vz}); }
int explorer_flip(void* p) { return device_at(p).flip() ? 1 : 0; }
void explorer_evaluate(void* p) {
  guarded([&] { return device_at(p).evaluate(), 1; });
}
double* explorer_values(void* p) { return device_at(p).values().data(); }
const char* explorer_layout(void* p) { return row_layout(device_at(p), device_at(p).values()); }
int explorer_drawing_count(void* p) {
  device_at(p).drawn = device_at(p).draw();
  return device_at(p).drawn.size();
}
double* explorer_drawing(void* p) { return device_at(p).drawn.data(); }
double* explorer_bounds(void* p) { return device_at(p).bounds(); }
int explorer_outline(void* p, int region) {
  return points_of(p, [&](device& held) { return held.outline(region); });
}
int explorer_locus(void* p, int brake, double length) {
  return points_of(p, [&](device& held) { return held.locus(brake, length); });
}
int explorer_walls(void* p, double low_x, double low_y, double high_x, double high_y) {
  return points_of(p,
                   [&](device& held) { return held.parts().wall.surface({low_x, low_y}, {high_x, high_y}); });
}
double* explorer_points(void* p) { return device_at(p).points.data(); }

void* sim_new(const char* given) {
  return guarded([&]() -> void* { return new simulation_handle(settings_of(given)); });
}
void sim_delete(void* p) { delete &simulation_at(p); }
int sim_set(void* p, const char* given) {
  return guarded([&] { return simulation_at(p).set(settings(given)), 1; });
}
void sim_step(void* p, int cycles, double x, double y, double z, int is_held) {
  simulation_at(p).step(cycles, {x, y, z}, is_held != 0);
}
void sim_restart(void* p) { simulation_at(p).restart(); }
double* sim_ring(void* p) { return simulation_at(p).ring(); }
double sim_cycles(void* p) { return simulation_at(p).cycles(); }
const char* sim_layout(void* p) { return row_layout(simulation_at(p), simulation_at(p).row()); }
double* sim_figures(void* p) { return simulation_at(p).figures(); }
void sim_record(void* p, int is_on) { simulation_at(p).record(is_on != 0); }
const char* sim_log(void* p) { return kept(simulation_at(p).text, simulation_at(p).log()); }

void* log_open(const char* given, const char* text) {
  return guarded([&]() -> void* { return new log_handle(device_parts(settings_of(given)), text); });
}
void log_delete(void* p) { delete &log_at(p); }
int log_count(void* p) { return log_at(p).count(); }
double* log_row(void* p, int line) { return log_at(p).row(line).data(); }
const char* log_layout(void* p) { return row_layout(log_at(p), log_at(p).row(-1)); }
double* log_agreement(void* p) { return log_at(p).agreement(); }

void* map_new(void* p, int columns, int rows, double low_x, double low_y, double high_x, double high_y) {
  return guarded([&]() -> void* {
    const configuration& c = device_at(p).parts().settings;
    return new figure_map(c, columns, rows, {low_x, low_y}, {high_x, high_y});
  });
}
void map_delete(void* p) { delete &at<figure_map>(p); }
int map_advance(void* p, int rows) {
  return guarded([&] { return at<figure_map>(p).advance(rows); });
}
double* map_figure(void* p, int figure) {
  return guarded([&] { return at<figure_map>(p).figure(figure); });
}
}
