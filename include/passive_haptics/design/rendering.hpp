/// @file
/// The figures of what a device renders at one place, each with the band in which a real one is expected.
#pragma once

#include <array>
#include <cstddef>
#include <cstdio>
#include <string>

namespace passive_haptics {

/// A band by factors of a figure, from devices that were simulated.
struct band {
  double low;          ///< Times the figure.
  double high;         ///< Times the figure.
  double share;        ///< Of random devices that lie in it, the least of 20 seeds [1].
  const char* source;  ///< What was measured of each device.
};

/// A figure and the ends of its band.
struct banded {
  double value = 0;         ///< What the formula gives.
  double low = 0;           ///< Lower end.
  double high = 0;          ///< Upper end.
  double share = 0;         ///< As in band.
  const char* source = "";  ///< As in band.

  /// Whether a measured value lies in the band, its ends included.
  bool contains(double measured) const { return low <= measured && measured <= high; }
};

/// The bands of expected_rendering(). Where they come from and why they are so wide:
/// docs/guide/data_sheet.md.
struct rendering_bands {
  /// Of rendering::free_drag.
  static constexpr band free_drag{2.0 / 3, 1.5, 0.91, "mean force of a hand that moves the handle"};
  /// Of rendering::wall_drag, of hands that the brakes hold.
  static constexpr band wall_drag{0.5, 2, 0.90, "mean force of a hand that slides and is held"};
  /// Of rendering::strongest_force.
  static constexpr band strongest_force{0.9, 1.1, 0.93, "force of the best of all commands"};
  /// Of rendering::stiffness.
  static constexpr band stiffness{1.0 / 16, 4, 0.90, "1.25 times a rigid wall's depth at low, twice at high"};
  /// Of rendering::depth: give or take a count of the encoders; or over 10 mm.
  static constexpr band depth{0.5, 2, 0.91, "deepest within 0.2 s of the touch"};
  /// Of rendering::release_time.
  static constexpr band release_time{0.5, 2.5, 0.91, "fall of the strongest torque to a tenth"};
  /// Of rendering::velocity_noise and rate_noise.
  static constexpr band rate_noise{0.8, 1.25, 0.93, "estimated less true rates of a steady motion"};
};

/// What a device renders at one place, for one motion of the handle; made by expected_rendering().
template <int Joints>
struct rendering {
  banded free_drag;        ///< Force that moves the handle against the residual torques [N].
  banded wall_drag;        ///< Force that moves a handle along the wall on which the hand pushes [N].
  banded strongest_force;  ///< Largest steady force out of the wall [N].
  banded stiffness;        ///< Largest useful stiffness of the wall [N/m].
  banded depth;            ///< Of a landing [m].
  banded release_time;     ///< After which brakes have let go of a hand that turns away [s].
  banded velocity_noise;   ///< Standard deviation of the handle's estimated velocity along the normal [m/s].
  std::array<banded, std::size_t(Joints)> rate_noise;  ///< Those of the joints' rates [rad/s or m/s].
  /// The brakes hold the push of a hand that slides along the wall. Else it sinks, and the wall_drag is not
  /// that of a slide: its band has no upper end.
  bool holds_push = false;
};

/// Calls f(name, unit, figure) for each figure, as "rate_noise[1]", "rad/s or m/s".
template <int Joints, class F>
void for_each_figure(const rendering<Joints>& r, F&& f) {
  f("free_drag", "N", r.free_drag);
  f("wall_drag", "N", r.wall_drag);
  f("strongest_force", "N", r.strongest_force);
  f("stiffness", "N/m", r.stiffness);
  f("depth", "m", r.depth);
  f("release_time", "s", r.release_time);
  f("velocity_noise", "m/s", r.velocity_noise);
  for (std::size_t i = 0; i < r.rate_noise.size(); ++i)
    f("rate_noise[" + std::to_string(i) + "]", "rad/s or m/s", r.rate_noise[i]);
}

/// A table for people: a line for each figure with its unit, value and band, the share of random devices that
/// are in the band, and what was measured of them.
template <int Joints>
std::string to_text(const rendering<Joints>& r) {
  std::string text;
  const auto line = [&](const char* figure, const char* value, const char* low, const char* high,
                        const char* share, const char* source) {
    char columns[160];
    std::snprintf(columns, sizeof columns, "%-29s %9s %9s %9s  %5s  %s\n", figure, value, low, high, share,
                  source);
    text.append(columns);
  };
  line("", "expected", "from", "to", "for", "of simulated devices");
  for_each_figure(r, [&](const std::string& name, const char* unit, const banded& figure) {
    const auto printed = [](const char* format, double x) {
      std::array<char, 16> digits{};
      std::snprintf(digits.data(), digits.size(), format, x);
      return digits;
    };
    line((name + " [" + unit + "]").c_str(), printed("%.3g", figure.value).data(),
         printed("%.3g", figure.low).data(), printed("%.3g", figure.high).data(),
         printed("%.0f %%", 100 * figure.share).data(), figure.source);
  });
  if (!r.holds_push) text.append("The brakes do not hold the push of a hand that slides here: it sinks.\n");
  return text;
}

}  // namespace passive_haptics
