/// @file
/// The laws of the explorer, and a controller whose law is chosen at run time.
#pragma once

#include "scene.hpp"
#include "settings.hpp"

#include <passive_haptics/brake/models/switchable_brakes.hpp>
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/laws/on_off_control.hpp>
#include <passive_haptics/control/laws/saturated_direct_control.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>

#include <memory>

namespace explorer {

/// Whether the forces are scaled: the paper's law, or none, in one type.
struct scaled_forces {
  static constexpr bool needs_hand_force = true;  ///< Needs a force sensor at the handle.
  /// As direct_control; at one wall, alpha = 1 makes no difference.
  static constexpr bool nulls_normal_force = true;
  bool is_direct = true;           ///< Direct control; else alpha as given.
  ph::direct_control direct = {};  ///< The law.
  double given = 1;                ///< alpha without the law.

  /// The table of core/parameters.hpp: that of the law.
  static constexpr auto members() { return ph::member_table(ph::member("direct", &scaled_forces::direct)); }

  /// alpha
  template <class T, int D>
  T scale(const ph::contact_situation<T, D>& c) const noexcept {
    return is_direct ? direct.scale(c) : T(given);
  }
};

/// The laws, in the order of the catalogue.
enum class law_kind {
  no_direct_control,
  direct_control,
  saturated_direct_control,
  velocity_direct_control,
  on_off_control
};

/// What the catalogue has of a law.
struct law_description {
  law_kind kind;         ///< Which.
  const char* id;        ///< Its name in the library.
  const char* look;      ///< One sentence: what it does.
  const char* equation;  ///< Of the paper.
};

/// All laws.
inline constexpr law_description laws[] = {
    {law_kind::no_direct_control, "no_direct_control",
     "The brakes make the force nearest to the wall's, as hard as they can: the hand bounces.", ""},
    {law_kind::direct_control, "direct_control",
     "Where the handle moves out, alpha scales the force so that nothing of the resultant is left normal to "
     "the "
     "wall.",
     "12"},
    {law_kind::saturated_direct_control, "saturated_direct_control",
     "Alpha scales what the brakes can make, as the paper's experiments read it: the brakes let go while the "
     "handle "
     "moves out.",
     "12"},
    {law_kind::velocity_direct_control, "velocity_direct_control",
     "The brakes keep the handle at a small depth by the inertia of the device and their own lag: it glides.",
     ""},
    {law_kind::on_off_control, "on_off_control",
     "The whole force or none, by a relay that looks ahead by the lag of the brakes.", ""}};

/// The law of an id. Throws std::invalid_argument.
law_kind law_of(const std::string& id);
/// The id of a law.
const char* id_of(law_kind kind);

/// The parameters of all laws; those of the chosen one are shown.
struct law_settings {
  ph::direct_control direct;                        ///< Of direct_control.
  ph::saturated_direct_control saturated;           ///< Of saturated_direct_control.
  ph::velocity_direct_control_parameters velocity;  ///< Of velocity_direct_control.
  ph::on_off_parameters on_off;                     ///< Of on_off_control.
  double given_scale = 1;                           ///< alpha of no_direct_control.

  /// Calls f(table) with that of a law, if it has one.
  template <class F>
  void visit(law_kind kind, F&& f) {
    switch (kind) {
      case law_kind::direct_control: return f(direct);
      case law_kind::saturated_direct_control: return f(saturated);
      case law_kind::velocity_direct_control: return f(velocity);
      case law_kind::on_off_control: return f(on_off);
      case law_kind::no_direct_control: return;
    }
  }
};

/// A controller of mechanism M whose law is known at run time only.
template <class M>
class any_control {
 public:
  using brakes = ph::switchable_brakes<M>;          ///< Its brakes.
  using scene = explorer_scene<M::task_dimension>;  ///< Its scene.

  virtual ~any_control() = default;
  /// One control cycle.
  virtual ph::step_result<M> decide(const ph::device_state<M>& state) = 0;
  /// Whether the torque limits cut each brake on its own; else they scale all brakes by one factor.
  virtual bool cuts_each_brake() const = 0;
};

namespace detail {

template <class M, class L>
class control_of final : public any_control<M> {
  using base = any_control<M>;

 public:
  control_of(const M& mechanism, const typename base::brakes& brakes, typename base::scene scene,
             const L& law, const ph::step_options<double>& options)
      : control_(mechanism, brakes, std::move(scene), law, options) {}
  ph::step_result<M> decide(const ph::device_state<M>& state) override { return control_(state); }
  bool cuts_each_brake() const override { return ph::TorqueLaw<L>; }

 private:
  ph::controller<M, typename base::scene, L, typename base::brakes> control_;
};

}  // namespace detail

/// The controller under a law.
template <class M>
std::unique_ptr<any_control<M>> make_control(law_kind kind, const law_settings& law, const M& mechanism,
                                             const typename any_control<M>::brakes& brakes,
                                             typename any_control<M>::scene scene,
                                             const ph::step_options<double>& options) {
  const auto under = [&]<class L>(const L& chosen) -> std::unique_ptr<any_control<M>> {
    return std::make_unique<detail::control_of<M, L>>(mechanism, brakes, std::move(scene), chosen, options);
  };
  switch (kind) {
    case law_kind::no_direct_control: return under(scaled_forces{false, {}, law.given_scale});
    case law_kind::direct_control: return under(scaled_forces{true, law.direct, 1});
    case law_kind::saturated_direct_control: return under(law.saturated);
    case law_kind::velocity_direct_control: return under(ph::velocity_direct_control(law.velocity));
    case law_kind::on_off_control: break;
  }
  return under(ph::on_off_control{law.on_off});
}

}  // namespace explorer
