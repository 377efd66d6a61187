/// Metrics of wall following.
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

namespace passive_haptics {

/// End of a run along a wall.
enum class run_end {
  time_over,  ///< max_duration was over.
  arrived,    ///< The end of the path was reached.
  too_deep,   ///< max_depth was exceeded.
  not_finite  ///< The depth was not finite.
};

/// Text of a run_end.
constexpr std::string_view to_string(run_end e) {
  switch (e) {
    case run_end::time_over: return "time over";
    case run_end::arrived: return "arrived";
    case run_end::too_deep: return "too deep";
    case run_end::not_finite: return "depth not finite";
  }
  return "unknown run_end";
}

/// Figures of one run along a wall, from the first contact.
struct contact_metrics {
  int separations = 0;               ///< Contact followed by a depth under -10 um.
  int recontacts = 0;                ///< Separation followed by a depth over +10 um.
  double depth_mean = 0;             ///< Mean depth after the first 10 % of the path [m].
  double depth_std = 0;              ///< Standard deviation of the depth there [m].
  double depth_range = 0;            ///< Maximum minus minimum depth there [m].
  double depth_drift = 0;            ///< Last minus first depth there [m]; < 0 moves out of the wall.
  double max_depth = 0;              ///< Maximum depth on the whole path [m].
  double stick_share = 0;            ///< Share of time with the watched brake below 1e-3 rad/s [1].
  double hand_force_std = 0;         ///< Standard deviation of the hand's force into the wall [N].
  double retarding_force = 0;        ///< Mean force of the brakes against the motion along the wall [N].
  double brake_energy = 0;           ///< Dissipated by the friction of all brakes [J].
  double max_brake_power = 0;        ///< Maximum power that one brake gave to the device in a step [W].
  double duration = 0;               ///< From the first contact to the end [s].
  bool arrived = false;              ///< The end of the path was reached.
  bool touched = false;              ///< The wall was touched.
  run_end end = run_end::time_over;  ///< Reason for the end; set by follow_wall.

  static constexpr double floating_depth = -0.5e-3;  ///< Mean depth below which the handle floats [m].
  static constexpr double deep_depth = 10e-3;        ///< Maximum depth above which it is deep [m].

  bool separates() const { return separations > 0; }           ///< The handle left the wall.
  bool floats() const { return depth_mean < floating_depth; }  ///< The handle hovers in front of the wall.
  bool never_touches() const { return !touched; }              ///< The handle never reached the wall.
  bool is_deep() const { return max_depth > deep_depth; }      ///< The handle went far into the wall.
};

/// Input of contact_meter, one per time step.
struct contact_sample {
  double progress = 0;         ///< Distance along the path [m].
  double depth = 0;            ///< [m], < 0 outside the wall.
  double rate = 0;             ///< Rate of the watched brake [rad/s or m/s].
  double retarding_force = 0;  ///< Brake force against the motion along the wall [N].
  double brake_energy = 0;     ///< Dissipated in this time step [J].
  double brake_power = 0;      ///< Maximum of the brakes' powers t_i w_i [W].
  double hand_force = 0;       ///< Hand force into the wall [N].
};

/// Collects contact_metrics at equal time steps, without allocation.
class contact_meter {
 public:
  static constexpr double hysteresis = 10e-6;    ///< Minimum depth change of a separation [m].
  static constexpr double settling_share = 0.1;  ///< Share of the path left out of the depth statistics.
  static constexpr double stick_rate = 1e-3;     ///< Rate below which a brake counts as stuck [rad/s].

  /// path_end: progress at the end of the path [m]; dt: time step [s].
  contact_meter(double path_end, double dt) : path_end_(path_end), dt_(dt) {}

  /// Adds a sample.
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

  /// Figures so far.
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
  // Mean and squared deviations after Welford, which is numerically stable
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
