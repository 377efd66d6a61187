/// @file
/// The motion of a device at 1 kHz under a law, with a hand; ten time steps of the plant in each cycle.
#pragma once

#include "parts.hpp"
#include "value_table.hpp"

#include <passive_haptics/plant/following_hand.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace explorer {

/// The columns of a row: what a cycle saw, decided and did.
value_table row_table(const configuration& c);
/// Puts state and decision of a cycle.
void put_cycle(value_table& row, const runtime::state_view& state, const runtime::cycle_record& r);

/// A simulated device.
class simulation {
 public:
  /// Begins at the state of the settings.
  explicit simulation(const configuration& c);
  /// Changes settings while it runs. Throws std::invalid_argument, with nothing changed.
  void set(const settings& changed);
  /// Runs cycles of 1 ms, in which the pointer goes evenly from where it was to `pointer` [m] and pulls by
  /// the hand's spring if it is held. A hand that moves by itself does not read it.
  void step(int cycles, const place& pointer, bool is_held);
  /// Begins again at the start of the settings.
  void restart();
  /// The last cycle.
  value_table& row() { return row_; }
  /// A row for each cycle of the last step().
  const std::vector<double>& rows() const { return rows_; }
  /// Since the start: separations while the hand pushes, and the time since the first contact [s].
  std::array<double, 2> figures() const { return {separations_, contact_time_}; }
  /// Begins a record of at most 2 minutes, which forgets the last one, or ends it.
  void record(bool is_on);
  /// The record as a log of the library, CSV (docs/guide/log.md).
  std::string log() const;

 private:
  // A cycle of the record.
  struct recorded {
    double time;
    joint_numbers q, qd;
    runtime::task_numbers hand_force;
    runtime::cycle_record decision;
    runtime::task_numbers position;
    double depth;
    joint_numbers rates, brake_torque;
  };

  std::unique_ptr<runtime::any_plant> plant_of(const device_parts& of, numbers q) const;
  void prepare_control();
  void prepare_hand();
  void one_cycle(bool is_held);
  void count_separation(double depth, bool is_pushed);
  void put_row(const runtime::state_view& state, const runtime::cycle_record& r, const place& muscle);
  place muscle_force(bool is_held, double time) const;
  double depth() const;
  place position() const { return place_of(plant_->position()); }
  place velocity() const { return place_of(plant_->velocity()); }

  device_parts parts_;
  std::unique_ptr<runtime::any_plant> plant_;
  page_controller control_;
  std::optional<ph::following_hand<double, 3>> hand_;
  place start_, pointer_;
  bool is_pointed_ = false, is_recording_ = false, is_in_contact_ = false;
  double separations_ = 0, contact_time_ = 0;  // [1], [s]
  double motion_time_ = 0;                     // since the start of the hand's way [s]
  long cycles_ = 0;
  value_table row_;
  std::vector<double> rows_;
  std::vector<recorded> record_;
};

}  // namespace explorer
