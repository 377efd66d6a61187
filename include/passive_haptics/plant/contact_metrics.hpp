/// @file
/// How smoothly a wall was followed: one definition for all experiments.
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

namespace passive_haptics {

/// How a run along a wall ended.
enum class run_end {
  time_over,  ///< Its longest time was over.
  arrived,    ///< The end of the path was reached.
  too_deep,   ///< The handle was deeper than the run allows.
  not_finite  ///< The depth was not a finite number.
};

/// In words.
constexpr std::string_view to_string(run_end e) {
  switch (e) {
    case run_end::time_over: return "time over";
    case run_end::arrived: return "arrived";
    case run_end::too_deep: return "too deep";
    case run_end::not_finite: return "depth not finite";
  }
  return "unknown run_end";
}

/// Figures of one run along a wall, counted from the first contact.
struct contact_metrics {
  int separations = 0;               ///< Contact followed by a depth under -10 um.
  int recontacts = 0;                ///< Separation followed by a depth over +10 um.
  double depth_mean = 0;             ///< Mean depth after the first 10 % of the path [m].
  double depth_std = 0;              ///< Standard deviation of the depth there [m].
  double depth_range = 0;            ///< Largest less smallest depth there [m].
  double depth_drift = 0;            ///< Last less first depth there [m]; < 0 moves out of the wall.
  double max_depth = 0;              ///< Largest depth on the whole path [m].
  double stick_share = 0;            ///< Share of time that the watched brake is slower than 1e-3 rad/s [1].
  double hand_force_std = 0;         ///< Standard deviation of the hand's force into the wall [N].
  double retarding_force = 0;        ///< Mean force of the brakes against the motion along the wall [N].
  double brake_energy = 0;           ///< Dissipated by the friction of all brakes [J].
  double max_brake_power = 0;        ///< Largest that one brake gave to the device in a step [W]; 0 if none.
  double duration = 0;               ///< From the first contact to the end [s].
  bool arrived = false;              ///< The end of the path was reached.
  bool touched = false;              ///< The wall was touched at all.
  run_end end = run_end::time_over;  ///< How the run ended; follow_wall sets it.

  static constexpr double floating_depth = -0.5e-3;  ///< A mean depth [m] under which the handle floats.
  static constexpr double deep_depth = 10e-3;        ///< A depth [m] over which it is deep.

  /// The handle left the wall at least once.
  bool separates() const { return separations > 0; }
  /// It hovers in front of the wall.
  bool floats() const { return depth_mean < floating_depth; }
  /// It never reached the wall.
  bool never_touches() const { return !touched; }
  /// It went far into the wall.
  bool is_deep() const { return max_depth > deep_depth; }
};

/// Input of contact_meter, one a time step.
struct contact_sample {
  double progress = 0;         ///< Way made [m].
  double depth = 0;            ///< Into the wall [m], < 0 outside.
  double rate = 0;             ///< Of the watched brake's axis [rad/s or m/s].
  double retarding_force = 0;  ///< Of the brakes, against the motion along the wall [N].
  double brake_energy = 0;     ///< Dissipated by the brakes in this time step [J].
  double brake_power = 0;      ///< Largest of the brakes' powers t_i w_i [W].
  double hand_force = 0;       ///< Of the hand on the handle, into the wall [N].
};

/// Collects contact_metrics sample by sample at equal time steps; no allocation.
class contact_meter {
 public:
  static constexpr double hysteresis = 10e-6;    ///< Of the depth [m]: less is no separation.
  static constexpr double settling_share = 0.1;  ///< Of the path, left out of the depth's statistics.
  static constexpr double stick_rate = 1e-3;     ///< Slower counts as stuck [rad/s].

  /// For a path that ends where progress reaches path_end [m], sampled every dt [s].
  contact_meter(double path_end, double dt) : path_end_(path_end), dt_(dt) {}

  /// One sample.
  void add(const contact_sample& now) {
    const double progress = now.progress, depth = now.depth;
    if (progress >= path_end_) result_.arrived = true;
    if (!result_.touched) {
      if (!(depth > 0)) return;
      result_.touched = in_contact_ = true;
      settled_at_ = progress + settling_share * (path_end_ - progress);
    }
    if (in_contact_ && depth < -hysteresis) {
      in_contact_ = false;
      ++result_.separations;
    } else if (!in_contact_ && depth > hysteresis) {
      in_contact_ = true;
      ++result_.recontacts;
    }
    if (std::abs(now.rate) < stick_rate) ++stuck_;
    retarding_force_.add(now.retarding_force);
    hand_force_.add(now.hand_force);
    result_.brake_energy += now.brake_energy;
    result_.max_brake_power = std::max(result_.max_brake_power, now.brake_power);
    result_.max_depth = std::max(result_.max_depth, depth);
    if (progress >= settled_at_) settled_depth_.add(depth);
  }

  /// The figures so far.
  contact_metrics result() const {
    contact_metrics r = result_;
    if (hand_force_.count > 0) {
      r.stick_share = stuck_ / hand_force_.count;
      r.retarding_force = retarding_force_.mean;
      r.hand_force_std = hand_force_.standard_deviation();
      r.duration = hand_force_.count * dt_;
    }
    if (settled_depth_.count > 0) {
      r.depth_mean = settled_depth_.mean;
      r.depth_std = settled_depth_.standard_deviation();
      r.depth_range = settled_depth_.maximum - settled_depth_.minimum;
      r.depth_drift = settled_depth_.last - settled_depth_.first;
    }
    return r;
  }

 private:
  // Mean and sum of squared deviations are stable, after Welford
  struct statistics {
    double count = 0, mean = 0, squares = 0, minimum = 0, maximum = 0, first = 0, last = 0;

    void add(double x) {
      if (count == 0) first = minimum = maximum = x;
      last = x;
      minimum = std::min(minimum, x);
      maximum = std::max(maximum, x);
      const double before = x - mean;
      mean += before / ++count;
      squares += before * (x - mean);
    }
    double standard_deviation() const { return std::sqrt(squares / count); }
  };

  double path_end_, dt_;
  contact_metrics result_;
  bool in_contact_ = false;
  double settled_at_ = 0;
  int stuck_ = 0;
  statistics settled_depth_, hand_force_, retarding_force_;
};

}  // namespace passive_haptics
