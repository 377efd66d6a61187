/// Brakes with a model chosen at run time.
#pragma once

#include <passive_haptics/brake/models/brake_model.hpp>

#include <concepts>
#include <tuple>
#include <variant>

namespace passive_haptics {

/// One of these Models, with a common scalar. No heap, no virtual call.
template <BrakeModel... Models>
class any_brake {
  // Models may share a type of state
  template <class Model>
  struct state_of {
    typename Model::state value;
  };

 public:
  using scalar = typename std::tuple_element_t<0, std::tuple<Models...>>::scalar;  ///< Scalar of all models.
  /// The states of all models; only that of the model in use changes.
  using state = std::tuple<state_of<Models>...>;

  brake_resistance<scalar> residual;  ///< As the model.
  scalar compliance;                  ///< As the model [rad/(N m)].

  /// Copies the model. Implicit, so that a model converts to any_brake. Throws std::invalid_argument with the
  /// text of validate(model) if the model has a table of parameters.
  template <class Model>
    requires(std::same_as<Model, Models> || ...)
  any_brake(const Model& model)
      : residual(residual_of(model)), compliance(compliance_of(model)), model_(model) {
    if constexpr (Parameters<Model>) require_valid(model);
  }

  /// As BrakeModel.
  brake_resistance<scalar> advance(scalar dt, scalar command, scalar rate, state& now) const noexcept {
    const auto advance = [&]<class Model>(const Model& model) {
      return model.advance(dt, command, rate, std::get<state_of<Model>>(now).value);
    };
    return std::visit(advance, model_);
  }

  /// As InvertibleBrakeModel.
  scalar command_for(scalar torque, scalar rate, const state& now) const noexcept
    requires(InvertibleBrakeModel<Models> && ...)
  {
    const auto command_for = [&]<class Model>(const Model& model) {
      return model.command_for(torque, rate, std::get<state_of<Model>>(now).value);
    };
    return std::visit(command_for, model_);
  }

  /// As BrakeModel.
  scalar torque_limit_at(scalar rate) const noexcept {
    return std::visit([&](const auto& model) { return model.torque_limit_at(rate); }, model_);
  }

 private:
  std::variant<Models...> model_;
};

}  // namespace passive_haptics
