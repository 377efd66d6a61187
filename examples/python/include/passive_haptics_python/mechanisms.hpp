/// @file
/// Mechanisms and their brakes in Python.
#pragma once

#include <passive_haptics_python/controller_of.hpp>

namespace passive_haptics_python {

/// The base class of the brakes of all devices.
struct brakes {
  /// As of a base class.
  virtual ~brakes() = default;
};

/// The brakes of a device that has this number of them.
template <int Brakes>
using brakes_value = table_value<brakes, ph::brake_parameters<double, Brakes>>;

/// The base class of all mechanisms.
struct mechanism {
  /// As of a base class.
  virtual ~mechanism() = default;
  /// n, d and m.
  virtual device_sizes sizes() const = 0;
  /// The controller; a TypeError or ValueError if something does not fit the mechanism.
  virtual std::unique_ptr<any_controller> make_controller(const py::object& of_brakes, const scene& walls,
                                                          const py::object& of_law,
                                                          const ph::step_options<double>& options) const = 0;
};

namespace detail {

// The name of law L in Python.
template <class L>
std::string law_name() {
  return py::str(py::type::of<law_value<L>>().attr("__name__"));
}

}  // namespace detail

/// Mechanism M of parameters P, with the laws that it is built with.
template <class M, ph::Parameters P, class Laws>
class mechanism_value;

/// With these laws.
template <class M, ph::Parameters P, class... Laws>
class mechanism_value<M, P, law_list<Laws...>> : public mechanism {
 public:
  /// Of these parameters; throws std::invalid_argument.
  explicit mechanism_value(const P& p) : table_(p), model_(model_of(p)) {}

  /// The mechanism itself.
  const M& model() const { return model_; }
  /// n, d and m.
  device_sizes sizes() const override { return {M::dof, M::task_dimension, M::brake_count}; }
  /// The parameters of these brakes; a TypeError if they are those of another device.
  static const ph::brakes_of<M>& brakes_from(const py::object& given) {
    return expect<brakes_value<M::brake_count>>(
               given, "brakes", "what brakes() of the mechanism returns, for its number of brakes")
        .table;
  }
  /// The controller.
  std::unique_ptr<any_controller> make_controller(const py::object& of_brakes, const scene& walls,
                                                  const py::object& of_law,
                                                  const ph::step_options<double>& options) const override {
    const ph::brakes_of<M>& known_brakes = brakes_from(of_brakes);
    std::unique_ptr<any_controller> made;
    const auto try_law = [&]<class L>(std::type_identity<L>) {
      if (made || !py::isinstance<law_value<L>>(of_law)) return;
      const L chosen = made_law<L>(py::cast<const law_value<L>&>(of_law).table);
      made = passive_haptics_python::make_controller<M, L>(model_, known_brakes, walls, chosen, options);
    };
    (try_law(std::type_identity<Laws>()), ...);
    if (!made)
      refuse_type("law = " + shown(of_law) + ", expected a law that the mechanism is built with: " +
                  joined({detail::law_name<Laws>()...}));
    return made;
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
};

}  // namespace passive_haptics_python
