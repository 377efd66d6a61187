/// @file
/// The functions that the page calls: plain C, compiled to WebAssembly, or natively for the tests.
///
/// Texts are UTF-8 and end with a zero. A text or table that a function returns belongs to the engine and
/// stays until the next call of this function for this handle; numbers are read before the next call, as
/// memory may grow. Handles are addresses, 0 is none: then explorer_error() has the reason. Of vectors in the
/// plane z is 0.
///
/// ## Settings
/// A device, its law, scene and state are one text, *settings*: lines "NAME=VALUE". A link and a preset are
/// such a text, too. Numbers of a vector stand with commas: "q=0.785,1.571". Unnamed settings have their
/// defaults.
///
///     mechanism=tendon_two_link      an id of the catalogue
///     law=direct_control             an id of the catalogue
///     mechanism.length_1=0.15        a member of the mechanism's table
///     brakes.torque_limit=1,1        a member of the table of the brakes, one for each or one for all
///     brakes.present=1,0             joints that have brakes
///     law.margin=0.2                 a member of the table of the law
///     options.max_approximation_angle=1.55
///     scene=plane:0,0.225,0,-1       none, plane:POINT,NORMAL, solid:CENTRE,RADIUS, hollow:CENTRE,RADIUS,
///                                    edge:CORNER,NORMAL,NORMAL (plane only), outline:X,Y,X,Y,... (a polygon,
///                                    free outside), box:LOW,HIGH (space only)
///     scene.stiffness=1e7            [N/m]
///     scene.rate=20                  updates of the environment [Hz]; 0: each cycle
///     hand=pointer                   pointer, or along: a hand by itself that moves along the wall
///     hand.stiffness=300             of the spring between pointer and handle, and so on: see explorer_form
///     desired=scene                  scene, or given: F_d is the state's, as of a wall behind the handle
///     q=..., qd=..., Fh=..., Fd=...  the state; q and qd [rad or m], forces [N]
///     alpha=0.5                      the scale factor of a pose instead of the law's; -1: that of the law
#pragma once

#ifdef __EMSCRIPTEN__
#include <emscripten.h>
#define EXPLORER_EXPORT EMSCRIPTEN_KEEPALIVE
#else
#define EXPLORER_EXPORT
#endif

extern "C" {

/// The catalogue, JSON: {"mechanisms": [{"id", "label", "joints", "dimension", "brakes", "has_branches"}],
/// "laws": [{"id"}], "presets": [{"id", "title", "look", "settings"}]}.
EXPLORER_EXPORT const char* explorer_catalogue();
/// The error of the last call, in the words of the library; "" if there was none.
EXPLORER_EXPORT const char* explorer_error();

/// A device of these settings.
EXPLORER_EXPORT void* explorer_new(const char* settings);
/// Ends it.
EXPLORER_EXPORT void explorer_delete(void* device);
/// Changes settings, except the mechanism: make a new device for another one. 1; or 0, and nothing is
/// changed.
EXPLORER_EXPORT int explorer_set(void* device, const char* settings);
/// All lines that differ from the defaults, with the state: what explorer_new() makes the device from.
EXPLORER_EXPORT const char* explorer_settings(void* device);
/// The form of the device, JSON: a list of {"name": "mechanism.length_1", "group": "mechanism", "brakes",
/// "law", "options", "scene", "hand" or "map", "label", "unit", "expected", "kind": "number", "choice" or
/// "text", "choices", "size", "value", "default"}.
EXPLORER_EXPORT const char* explorer_form(void* device);

/// The state, n + n + 3 + 3 numbers that the page may write: q [rad or m], qd [rad/s or m/s], Fh and Fd [N].
EXPLORER_EXPORT double* explorer_state(void* device);
/// Moves q towards the pose with the handle at (x, y, z) [m], on the present branch. 1 if it was reached,
/// else 0, with q at the nearest reach.
EXPLORER_EXPORT int explorer_reach(void* device, double x, double y, double z);
/// Sets qd to the least joint rates that move the handle with (vx, vy, vz) [m/s].
EXPLORER_EXPORT void explorer_move(void* device, double vx, double vy, double vz);
/// Takes the other elbow of the same handle position; 0 if the mechanism has none.
EXPLORER_EXPORT int explorer_flip(void* device);

/// Computes all values at the present state: one control cycle of a fresh controller, and what is drawn.
EXPLORER_EXPORT void explorer_evaluate(void* device);
/// The values of the last explorer_evaluate(), a flat table as explorer_layout() describes it.
EXPLORER_EXPORT double* explorer_values(void* device);
/// The names of the values (pose.cpp), JSON, with the length of the table: {"row": 120, "values": [{"id",
/// "label", "symbol", "equation", "unit", "group", "offset", "size", "columns": 1 or the length of each row,
/// "words": of an enumeration, which counts from 0}]}.
EXPLORER_EXPORT const char* explorer_layout(void* device);

/// The drawing at the present state: rows of 10 numbers, kind, number, x0, y0, z0, x1, y1, z1, size, angle;
/// points in m, base frame. Kinds, with the meaning of the rest:
///
///     0 ground    at 0; size: half width           5 pulley    at 0; size: radius; angle: how far it turned
///     1 link      from 0 to 1                                  [rad]; number: of the brake from 0
///     2 joint     at 0, turns about 1 - 0          6 belt      a straight run of a tendon from 0 to 1
///     3 slide     a rail from 0 to 1               7 brake     at 0, axis 1 - 0; as a pulley
///     4 carriage  at 0, moves along 1 - 0          8 platform  an edge from 0 to 1
///                                                  9 handle    at 0
EXPLORER_EXPORT double* explorer_drawing(void* device);
/// Rows of the drawing; call it first, it computes them.
EXPLORER_EXPORT int explorer_drawing_count(void* device);
/// The box of all that this device can reach [m]: low x, y, z, high x, y, z.
EXPLORER_EXPORT double* explorer_bounds(void* device);

/// The outline of the forces [N] that the brakes can produce within their limits in one region of torque
/// signs, 0 to 2^m - 1 as in passive_fme.hpp: (+,+), (+,-), (-,+), (-,-); -1: the region of the present
/// signs, also with brakes at rest. Returns the number of its points. In the plane a closed polygon, in space
/// triangles.
EXPLORER_EXPORT int explorer_outline(void* device, int region);
/// Positions of the handle while one brake (from 0) holds and the others rotate, over a length [m] to each
/// side of the present handle. Returns the number of its points; 0 unless the device has two joints.
EXPLORER_EXPORT int explorer_locus(void* device, int brake, double length);
/// The wall inside low x, y to high x, y. Returns the number of points; every 2 a segment in the plane, every
/// 3 a triangle in space.
EXPLORER_EXPORT int explorer_walls(void* device, double low_x, double low_y, double high_x, double high_y);
/// The points of the last of these three functions, x y z each [N or m].
EXPLORER_EXPORT double* explorer_points(void* device);

/// A simulation at 1 kHz that starts at the state of these settings.
EXPLORER_EXPORT void* sim_new(const char* settings);
/// Ends it.
EXPLORER_EXPORT void sim_delete(void* sim);
/// Changes settings while it runs (law, limits, scene, hand); the motion goes on. 1, or 0 with nothing
/// changed.
EXPLORER_EXPORT int sim_set(void* sim, const char* settings);
/// Runs so many cycles of 1 ms, in which the pointer goes evenly from where it was to (x, y, z) [m] and pulls
/// by the hand's spring if is_held; else the hand lets go. Under hand=along the pointer is not read.
EXPLORER_EXPORT void sim_step(void* sim, int cycles, double x, double y, double z, int is_held);
/// Continues from the start of the settings.
EXPLORER_EXPORT void sim_restart(void* sim);
/// The last 4096 cycles as rows of the layout: cycle k (from 0) is row k % 4096.
EXPLORER_EXPORT double* sim_ring(void* sim);
/// Cycles so far.
EXPLORER_EXPORT double sim_cycles(void* sim);
/// The columns of a row (simulation.cpp), JSON as of explorer_layout().
EXPLORER_EXPORT const char* sim_layout(void* sim);
/// Two figures since the start: separations while the hand pushes, and the time since the first contact [s].
EXPLORER_EXPORT double* sim_figures(void* sim);
/// Begins to record (1), or stops (0); a new record forgets the last. At most 2 minutes.
EXPLORER_EXPORT void sim_record(void* sim, int is_on);
/// The record as a log of the library, CSV (docs/guide/log.md).
EXPLORER_EXPORT const char* sim_log(void* sim);

/// A log of the library's format, run through the law of these settings.
EXPLORER_EXPORT void* log_open(const char* settings, const char* text);
/// Ends it.
EXPLORER_EXPORT void log_delete(void* log);
/// Its lines.
EXPLORER_EXPORT int log_count(void* log);
/// A line as a row of the layout of the simulation; NaN for what the log does not have.
EXPLORER_EXPORT double* log_row(void* log, int line);
/// The columns of a row.
EXPLORER_EXPORT const char* log_layout(void* log);
/// Lines with capacities equal to those of the law to the last digit, of those that have any: two numbers.
EXPLORER_EXPORT double* log_agreement(void* log);

/// A map of this device over a grid of points inside low to high [m] (in space at the height of the handle),
/// for a hand that moves and pushes in the directions of the settings map.direction and map.normal.
EXPLORER_EXPORT void* map_new(void* device, int columns, int rows, double low_x, double low_y, double high_x,
                              double high_y);
/// Ends it.
EXPLORER_EXPORT void map_delete(void* map);
/// Computes up to so many rows more; returns those that are done.
EXPLORER_EXPORT int map_advance(void* map, int rows);
/// rows x columns numbers from low y upwards, NaN out of reach: 0 the cosine of the approximation angle, 1
/// the class, as of `display`.
EXPLORER_EXPORT double* map_figure(void* map, int figure);
}
