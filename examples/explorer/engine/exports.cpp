#include "exports.hpp"

#include "device.hpp"

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

// Calls f; what it throws becomes the text of explorer_error(), and `refused` is returned.
template <class R, class F>
R guarded(R refused, F&& f) {
  last_error().clear();
  try {
    return f();
  } catch (const std::exception& error) {
    last_error() = error.what();
  } catch (...) {
    last_error() = "an unknown error";
  }
  return refused;
}

// A handle with the texts and tables that it has returned.
template <class T>
struct handle {
  std::unique_ptr<T> held;
  std::string text, layout, command;
  std::vector<double> points;
};
using device_handle = handle<device>;
using simulation_handle = handle<simulation>;
using log_handle = handle<replayed_log>;
using map_handle = handle<figure_map>;

device_handle& device_at(void* p) { return *static_cast<device_handle*>(p); }
simulation_handle& simulation_at(void* p) { return *static_cast<simulation_handle*>(p); }
log_handle& log_at(void* p) { return *static_cast<log_handle*>(p); }
map_handle& map_at(void* p) { return *static_cast<map_handle*>(p); }

template <class Handle, class Made>
void* handle_of(Made made) {
  auto p = std::make_unique<Handle>();
  p->held = std::move(made);
  return p.release();
}

// Keeps the points that f returns, and returns their number.
template <class F>
int points_of(void* p, F&& f) {
  return guarded(0, [&] {
    device_at(p).points = f(*device_at(p).held);
    return int(device_at(p).points.size() / 3);
  });
}

template <class Handle>
const char* row_layout(Handle& h, value_table& table) {
  json_writer json;
  json.object([&] {
    json.put("row", table.size());
    json.name("values");
    table.write(json);
  });
  h.layout = json.text();
  return h.layout.c_str();
}

}  // namespace

extern "C" {

const char* explorer_catalogue() {
  static std::string text;
  text = catalogue();
  return text.c_str();
}
const char* explorer_error() { return last_error().c_str(); }

void* explorer_new(const char* given) {
  return guarded<void*>(nullptr, [&] { return handle_of<device_handle>(make_device(settings(given))); });
}
void explorer_delete(void* p) { delete static_cast<device_handle*>(p); }
int explorer_set(void* p, const char* given) {
  return guarded(0, [&] {
    device_at(p).held->set(settings(given));
    return 1;
  });
}
const char* explorer_settings(void* p) {
  device_at(p).text = device_at(p).held->changed().text();
  return device_at(p).text.c_str();
}
const char* explorer_form(void* p) {
  device_at(p).command = device_at(p).held->form();
  return device_at(p).command.c_str();
}
double* explorer_state(void* p) { return device_at(p).held->state(); }
int explorer_reach(void* p, double x, double y, double z) {
  return device_at(p).held->reach(drawing::place(x, y, z)) ? 1 : 0;
}
void explorer_move(void* p, double vx, double vy, double vz) {
  device_at(p).held->move(drawing::place(vx, vy, vz));
}
int explorer_flip(void* p) { return device_at(p).held->flip() ? 1 : 0; }
void explorer_evaluate(void* p) {
  guarded(0, [&] {
    device_at(p).held->evaluate();
    return 1;
  });
}
double* explorer_values(void* p) { return device_at(p).held->values().data(); }
const char* explorer_layout(void* p) {
  json_writer json;
  device_at(p).held->values().write(json);
  device_at(p).layout = json.text();
  return device_at(p).layout.c_str();
}
int explorer_drawing_count(void* p) { return device_at(p).held->draw().size(); }
double* explorer_drawing(void* p) { return device_at(p).held->draw().data(); }
double* explorer_bounds(void* p) { return device_at(p).held->bounds(); }
int explorer_outline(void* p, int region) {
  return points_of(p, [&](device& held) { return held.outline(region); });
}
int explorer_locus(void* p, int brake, double length) {
  return points_of(p, [&](device& held) { return held.locus(brake, length); });
}
int explorer_walls(void* p, double low_x, double low_y, double high_x, double high_y) {
  return points_of(p, [&](device& held) { return held.walls({low_x, low_y}, {high_x, high_y}); });
}
double* explorer_points(void* p) { return device_at(p).points.data(); }

void* sim_new(const char* given) {
  return guarded<void*>(
      nullptr, [&] { return handle_of<simulation_handle>(make_device(settings(given))->simulate()); });
}
void sim_delete(void* p) { delete static_cast<simulation_handle*>(p); }
int sim_set(void* p, const char* given) {
  return guarded(0, [&] {
    simulation_at(p).held->set(settings(given));
    return 1;
  });
}
void sim_step(void* p, int cycles, double x, double y, double z, int is_held) {
  simulation_at(p).held->step(cycles, drawing::place(x, y, z), is_held != 0);
}
void sim_restart(void* p) { simulation_at(p).held->restart(); }
double* sim_ring(void* p) { return simulation_at(p).held->ring(); }
double sim_cycles(void* p) { return simulation_at(p).held->cycles(); }
const char* sim_layout(void* p) { return row_layout(simulation_at(p), simulation_at(p).held->row()); }
double* sim_figures(void* p) { return simulation_at(p).held->figures(); }
void sim_record(void* p, int is_on) { simulation_at(p).held->record(is_on != 0); }
const char* sim_log(void* p) {
  simulation_at(p).text = simulation_at(p).held->log();
  return simulation_at(p).text.c_str();
}
const char* sim_device_file(void* p) {
  simulation_at(p).command = simulation_at(p).held->device_file();
  return simulation_at(p).command.c_str();
}

void* log_open(const char* given, const char* text) {
  return guarded<void*>(nullptr,
                        [&] { return handle_of<log_handle>(make_device(settings(given))->replay(text)); });
}
void log_delete(void* p) { delete static_cast<log_handle*>(p); }
int log_count(void* p) { return log_at(p).held->count(); }
double* log_row(void* p, int line) { return log_at(p).held->row(line).data(); }
const char* log_layout(void* p) { return row_layout(log_at(p), log_at(p).held->row(-1)); }
double* log_agreement(void* p) { return log_at(p).held->agreement(); }

void* map_new(void* p, int columns, int rows, double low_x, double low_y, double high_x, double high_y) {
  return guarded<void*>(nullptr, [&] {
    return handle_of<map_handle>(device_at(p).held->map(columns, rows, {low_x, low_y}, {high_x, high_y}));
  });
}
void map_delete(void* p) { delete static_cast<map_handle*>(p); }
int map_advance(void* p, int rows) {
  return guarded(0, [&] { return map_at(p).held->advance(rows); });
}
double* map_figure(void* p, int figure) {
  return guarded<double*>(nullptr, [&] { return map_at(p).held->figure(figure); });
}
}
