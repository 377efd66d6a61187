/// @file
/// A brake whose model is chosen at run time.
#pragma once

#include <passive_haptics/brake/models/brake_model.hpp>

#include <concepts>
#include <cstddef>
#include <tuple>
#include <utility>
#include <variant>

namespace passive_haptics {

/// One of these Models, of one scalar: for a device whose brakes are not all alike, or a model that a user
/// names. No heap, no virtual call.
template <BrakeModel... Models>
class any_brake {
 public:
  using scalar = typename std::tuple_element_t<0, std::tuple<Models...>>::scalar;  ///< Of all of them.
  using state = std::tuple<typename Models::state...>;  ///< What the one in use remembers is in it.

  brake_resistance<scalar> residual;  ///< That of the model.

  /// A copy of this model. Implicit, so that it stands wherever an any_brake does.
  template <class Model>
    requires(std::same_as<Model, Models> || ...)
  any_brake(const Model& model) : residual(residual_of(model)), model_(model) {}

  /// See BrakeModel.
  brake_resistance<scalar> advance(scalar dt, scalar command, scalar rate, state& now) const noexcept {
    brake_resistance<scalar> result;
    with_model([&](const auto& model, auto i) {
      result = model.advance(dt, command, rate, std::get<decltype(i)::value>(now));
    });
    return result;
  }

  /// See BrakeModel.
  scalar torque_limit_at(scalar rate) const noexcept {
    scalar limit{};
    with_model([&](const auto& model, auto) { limit = model.torque_limit_at(rate); });
    return limit;
  }

 private:
  // f(the model, its number)
  template <class F>
  void with_model(F&& f) const noexcept {
    with_model(std::index_sequence_for<Models...>(), f);
  }
  template <std::size_t... I, class F>
  void with_model(std::index_sequence<I...>, F&& f) const noexcept {
    const auto if_in_use = [&](auto i) {
      if (const auto* model = std::get_if<decltype(i)::value>(&model_)) f(*model, i);
    };
    (if_in_use(std::integral_constant<std::size_t, I>()), ...);
  }

  std::variant<Models...> model_;
};

}  // namespace passive_haptics
