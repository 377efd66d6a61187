/// Brakes with a model chosen at run time.
#pragma once

#include <passive_haptics/brake/models/brake_model.hpp>

#include <array>
#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace passive_haptics::runtime {

/// Holds a BrakeModel. Shared by its copies. Simulations are identical to those with the model itself.
class run_time_brake {
  static constexpr std::size_t max_state_size = 128;  // [bytes]

 public:
  using scalar = double;  ///< Scalar of all models.
  /// Storage for the state of the model.
  struct state {
    alignas(
        std::max_align_t) std::array<std::byte, max_state_size> of_model = {};  ///< Its state, once begun.
    bool has_begun = false;  ///< True once the state exists.
  };

  brake_resistance<double> residual;  ///< As the model.
  double compliance;                  ///< As the model [rad/(N m)].

  /// Holds a copy of this model.
  template <BrakeModel Model>
    requires(!std::same_as<Model, run_time_brake>)
  explicit run_time_brake(const Model& brake)
      : residual(residual_of(brake)),
        compliance(compliance_of(brake)),
        held_(std::make_shared<model<Model>>(brake)) {}

  /// As BrakeModel.
  brake_resistance<double> advance(double dt, double command, double rate, state& now) const noexcept {
    return held_->advance(dt, command, rate, now);
  }
  /// As BrakeModel.
  double torque_limit_at(double rate) const noexcept { return held_->torque_limit_at(rate); }

 private:
  struct any_model {
    virtual ~any_model() = default;
    virtual brake_resistance<double> advance(double dt, double command, double rate,
                                             state& now) const noexcept = 0;
    virtual double torque_limit_at(double rate) const noexcept = 0;
  };
  template <class Model>
  struct model final : any_model {
    using own_state = typename Model::state;
    static_assert(sizeof(own_state) <= max_state_size && std::is_trivially_copyable_v<own_state>);

    explicit model(const Model& m) : brake(m) {}
    brake_resistance<double> advance(double dt, double command, double rate,
                                     state& now) const noexcept override {
      if (!now.has_begun) new (now.of_model.data()) own_state();
      now.has_begun = true;
      return brake.advance(dt, command, rate,
                           *std::launder(reinterpret_cast<own_state*>(now.of_model.data())));
    }
    double torque_limit_at(double rate) const noexcept override { return brake.torque_limit_at(rate); }
    Model brake;
  };

  std::shared_ptr<const any_model> held_;
};

}  // namespace passive_haptics::runtime
