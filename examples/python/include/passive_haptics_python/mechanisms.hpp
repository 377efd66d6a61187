/// @file
/// Mechanisms and their brakes in Python.
#pragma once

#include <passive_haptics_python/device_of.hpp>

namespace passive_haptics_python {

/// The base class of the brakes of all devices.
struct brakes {
  /// As of a base class.
  virtual ~brakes() = default;
  /// The parameters, of any number of brakes.
  virtual brake_numbers values() const = 0;
};

/// switchable_brake_parameters with the bounds, which few brakes have, behind the others.
template <int Brakes>
struct brake_table : ph::switchable_brake_parameters<double, Brakes> {
  /// The table.
  static constexpr auto members() {
    using p = brake_table;
    constexpr ph::range size = ph::range::not_negative;
    return ph::member_table(
        ph::member("torque_limit", &p::torque_limit, "N m", size).remark_at_zero("the brake is off"),
        ph::member("rate_dead_band", &p::rate_dead_band, "rad/s", size),
        ph::member("torque_dead_band", &p::torque_dead_band, "N m", size),
        ph::member("time_constant", &p::time_constant, "s", size).suspicious_above(1),
        ph::member("torque_lower", &p::torque_lower, "N m", ph::lower_torques),
        ph::member("torque_upper", &p::torque_upper, "N m", ph::upper_torques));
  }
};

/// The brakes of a device that has this number of them.
template <int Brakes>
struct brakes_value : brakes {
  using table_type = brake_table<Brakes>;  ///< The struct of the table.

  table_type table = {};  ///< The parameters.

  /// The parameters, of any number of brakes.
  brake_numbers values() const override {
    return {table.torque_limit,  table.rate_dead_band, table.torque_dead_band,
            table.time_constant, table.torque_lower,   table.torque_upper};
  }
  /// The names of the parameters.
  static std::vector<std::string> names() { return member_names<table_type>(); }
  /// Of a dictionary.
  static brakes_value made(const py::dict& given, const std::string& name) {
    brakes_value b;
    assign_members(b.table, given, name);
    ph::require_no_error(ph::validate(b.table));
    return b;
  }
  /// All parameters.
  py::dict parameters() const { return to_dict(table); }
  /// Those that are not the defaults.
  py::dict changed() const { return changed_members(table, table_type{}); }
};

/// The base class of all mechanisms.
struct mechanism {
  /// As of a base class.
  virtual ~mechanism() = default;
  /// Its functions.
  virtual const any_device& device() const = 0;
  /// The controller; a TypeError or ValueError if something does not fit the mechanism.
  virtual std::unique_ptr<any_controller> make_controller(const brake_numbers& brakes, const scene& walls,
                                                          const py::object& of_law,
                                                          const ph::step_options<double>& options) const = 0;
  /// What recommended_law returns.
  virtual py::object recommended_law(const brake_numbers& brakes) const = 0;
};

namespace detail {

// The name of law L in Python.
template <class L>
std::string law_name() {
  return py::str(py::type::of<law_value<L>>().attr("__name__"));
}

}  // namespace detail

/// Mechanism M of parameters P, with the laws that it is built with. Model: what its functions are compiled
/// for, M itself or an any_mechanism that others share. DeviceLaws: the laws of those others, too.
template <class M, ph::Parameters P, class Laws, class Model = M, class DeviceLaws = Laws>
class mechanism_value;

/// With these laws.
template <class M, ph::Parameters P, class... Laws, class Model, class DeviceLaws>
class mechanism_value<M, P, law_list<Laws...>, Model, DeviceLaws> : public mechanism {
 public:
  /// Of these parameters; throws std::invalid_argument.
  explicit mechanism_value(const P& p)
      : table_(p), model_(model_of(p)), device_(Model(model_), ph::Dynamics<M>) {}

  /// The mechanism itself.
  const M& model() const { return model_; }
  /// Its functions.
  const any_device& device() const override { return device_; }
  /// The controller.
  std::unique_ptr<any_controller> make_controller(const brake_numbers& brakes, const scene& walls,
                                                  const py::object& of_law,
                                                  const ph::step_options<double>& options) const override {
    std::unique_ptr<any_controller> made;
    const auto try_law = [&]<class L>(std::type_identity<L>) {
      if (made || !py::isinstance<law_value<L>>(of_law)) return;
      const auto& chosen = py::cast<const law_value<L>&>(of_law);
      std::unique_ptr<any_batch> at_wall;
      if (const auto only = walls.only_wall<M::task_dimension>(); only && brakes.has_no_bounds())
        at_wall =
            batch_at_wall<M, L>(model_, brakes_from<M>(brakes), *only, made_law<L>(chosen.table), options);
      made = device_.make_controller(brakes, walls, chosen, options, std::move(at_wall));
    };
    (try_law(std::type_identity<Laws>()), ...);
    if (!made)
      refuse_type("law = " + shown(of_law) + ", expected a law that the mechanism is built with: " +
                  joined({detail::law_name<Laws>()...}));
    return made;
  }
  /// What recommended_law returns.
  py::object recommended_law(const brake_numbers& brakes) const override {
    using L = recommended_law_of<M>;
    const L chosen = ph::recommended_law(model_, brakes_from<M>(brakes));
    if constexpr (requires { chosen.parameters(); }) return py::cast(law_value<L>(chosen.parameters()));
    else return py::cast(law_value<L>(chosen.parameters));
  }

  /// The names of the parameters.
  static std::vector<std::string> names() { return member_names<P>(); }
  /// Of a dictionary.
  static mechanism_value made(const py::dict& given, const std::string& name) {
    P p{};
    assign_members(p, given, name);
    return mechanism_value(p);
  }
  /// All parameters.
  py::dict parameters() const { return to_dict(table_); }
  /// Those that are not the defaults.
  py::dict changed() const { return changed_members(table_, P{}); }

 private:
  static M model_of(const P& p) {
    if constexpr (std::is_same_v<P, no_parameters>) return M();
    else if constexpr (requires { p.mechanism(); }) return p.mechanism();
    else return M(p);
  }

  P table_;
  M model_;
  device_of<Model, DeviceLaws> device_;
};

}  // namespace passive_haptics_python
