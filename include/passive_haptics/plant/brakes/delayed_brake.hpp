/// Dead time of a brake.
#pragma once

#include <passive_haptics/brake/models/brake_model.hpp>

#include <array>

namespace passive_haptics {

/// Model that receives each command dead_time later, to the nearest time step. Changes of the command wait in
/// a queue; if it is full, the oldest change acts early.
template <BrakeModel Model, int Changes = 64>
struct delayed_brake {
  using scalar = typename Model::scalar;  ///< Scalar.

  Model model = {};  ///< The brake.
  /// Time from a command to its first effect [s]; two cycles at 1 kHz, assumed.
  scalar dead_time = scalar(0.002);

  /// State of the model and the queue.
  struct state : Model::state {
    /// A command and the time at which it acts.
    struct change {
      double due;      ///< [s]
      scalar command;  ///< [N m]
    };
    std::array<change, std::size_t(Changes)> waiting{};  ///< Ring buffer.
    int first = 0;                                       ///< Index of the oldest change.
    int count = 0;                                       ///< Number of waiting changes.
    double time = 0;                                     ///< Current time [s].
    scalar last = scalar(0);                             ///< The last command [N m].
    scalar acting = scalar(0);                           ///< Command in effect [N m].
  };

  /// As BrakeModel.
  brake_resistance<scalar> advance(scalar dt, scalar command, scalar rate, state& now) const noexcept {
    const scalar wanted = command > scalar(0) ? command : scalar(0);
    if (wanted != now.last) {
      if (now.count == Changes) act(now);
      now.waiting[at(now.first + now.count++)] = {now.time + static_cast<double>(dead_time), wanted};
      now.last = wanted;
    }
    const auto passed = static_cast<double>(valid_time_step(dt));
    const double soon = now.time + passed / 2;
    while (now.count > 0 && now.waiting[at(now.first)].due <= soon) act(now);
    now.time += passed;
    return model.advance(dt, now.acting, rate, now);
  }

  /// As the model [N m].
  scalar torque_limit_at(scalar rate) const noexcept { return model.torque_limit_at(rate); }

  /// As the model, if that is invertible; the dead time remains.
  scalar command_for(scalar torque, scalar rate, const state& now) const noexcept
    requires InvertibleBrakeModel<Model>
  {
    return model.command_for(torque, rate, now);
  }

  brake_resistance<scalar> residual() const { return residual_of(model); }  ///< As the model.
  scalar compliance() const { return compliance_of(model); }                ///< As the model [rad/(N m)].

  static constexpr auto members() {
    using p = delayed_brake;
    constexpr auto own = member("dead_time", &p::dead_time, "s", range::not_negative);
    if constexpr (Parameters<Model>) return member_table(member("model", &p::model), own);
    else return member_table(own);
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i % Changes); }

  static void act(state& now) {
    now.acting = now.waiting[at(now.first)].command;
    now.first = (now.first + 1) % Changes;
    --now.count;
  }
};

}  // namespace passive_haptics
