/// @file
/// A device whose mechanism is known at run time only: what exports.hpp does to one.
#pragma once

#include "drawing.hpp"
#include "settings.hpp"
#include "value_table.hpp"

#include <memory>
#include <string>
#include <vector>

namespace explorer {

/// The motion of a device at 1 kHz under a law, with a hand; see sim_new() and what follows it.
class simulation {
 public:
  virtual ~simulation() = default;
  /// Changes settings while it runs. Throws std::invalid_argument, with nothing changed.
  virtual void set(const settings& changed) = 0;
  /// Runs cycles of 1 ms; the pointer goes to `pointer` [m] meanwhile.
  virtual void step(int cycles, const drawing::place& pointer, bool is_held) = 0;
  /// Begins anew.
  virtual void restart() = 0;
  /// The last cycle.
  virtual value_table& row() = 0;
  /// The last cycles, row by row.
  virtual double* ring() = 0;
  /// Cycles so far.
  virtual double cycles() const = 0;
  /// The figures of sim_figures().
  virtual double* figures() = 0;
  /// Begins or ends a record.
  virtual void record(bool is_on) = 0;
  /// The record as a log.
  virtual std::string log() const = 0;
  /// The device file with which it replays; empty where there is none.
  virtual std::string device_file() const = 0;

  static constexpr int ring_size = 4096;  ///< Cycles that the ring holds.
};

/// A log that went through a law; see log_open().
class replayed_log {
 public:
  virtual ~replayed_log() = default;
  /// Its lines.
  virtual int count() const = 0;
  /// The columns, filled with a line.
  virtual value_table& row(int line) = 0;
  /// Capacities as in the log, of those compared.
  virtual double* agreement() = 0;
};

/// A design map that is computed row by row; see map_new().
class figure_map {
 public:
  virtual ~figure_map() = default;
  /// Computes rows; returns those that are done.
  virtual int advance(int rows) = 0;
  /// One figure.
  virtual double* figure(int number) = 0;
};

/// A device, its law, scene and state.
class device {
 public:
  virtual ~device() = default;
  /// Changes settings. Throws std::invalid_argument, with nothing changed.
  virtual void set(const settings& changed) = 0;
  /// What differs from the defaults, and the state.
  virtual settings changed() const = 0;
  /// The form, JSON.
  virtual std::string form() const = 0;
  /// q, qd, Fh, Fd.
  virtual double* state() = 0;
  /// Puts the handle at x [m]; whether it was reached.
  virtual bool reach(const drawing::place& x) = 0;
  /// Sets qd so that the handle moves with v [m/s].
  virtual void move(const drawing::place& v) = 0;
  /// Takes the other branch.
  virtual bool flip() = 0;
  /// Computes all values.
  virtual void evaluate() = 0;
  /// The values.
  virtual value_table& values() = 0;
  /// The drawing.
  virtual drawing& draw() = 0;
  /// The box of the reach [m]: low, high.
  virtual double* bounds() = 0;
  /// Points of what can be produced in a region [N].
  virtual const std::vector<double>& outline(int region) = 0;
  /// Handle positions over a length [m] to each side of the handle while this brake holds; none unless n = 2.
  virtual std::vector<double> locus(int brake, double length) = 0;
  /// Points of the walls.
  virtual std::vector<double> walls(const ph::vector<double, 2>& low, const ph::vector<double, 2>& high) = 0;
  /// A simulation from the state of now.
  virtual std::unique_ptr<simulation> simulate() const = 0;
  /// A log of this device. Throws std::runtime_error.
  virtual std::unique_ptr<replayed_log> replay(const std::string& log) const = 0;
  /// A map over a grid from low to high.
  virtual std::unique_ptr<figure_map> map(int columns, int rows, const ph::vector<double, 2>& low,
                                          const ph::vector<double, 2>& high) const = 0;
};

/// What the catalogue has of a mechanism, and how a device of it is made.
struct mechanism_entry {
  const char* id;                     ///< As in the settings.
  const char* label;                  ///< In words.
  int joints;                         ///< n
  int dimension;                      ///< d
  int brakes;                         ///< m
  bool has_branches;                  ///< Another pose puts the handle where it is, as of an elbow.
  std::unique_ptr<device> (*make)();  ///< One with all default settings.
};

// One function a mechanism, so that each stands in a source of its own.
mechanism_entry tendon_two_link_entry();
mechanism_entry two_link_entry();
mechanism_entry xy_table_entry();
mechanism_entry five_bar_entry();
mechanism_entry five_bar_4_entry();
mechanism_entry planar_3r_entry();
mechanism_entry delta_entry();
mechanism_entry spatial_3r_entry();

/// All mechanisms, in the order of the catalogue.
const std::vector<mechanism_entry>& mechanisms();
/// The device of a text of settings. Throws std::invalid_argument.
std::unique_ptr<device> make_device(const settings& given);
/// The catalogue, JSON.
std::string catalogue();

}  // namespace explorer
