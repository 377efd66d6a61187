/// @file
/// Mechanisms and controllers as Python holds them.
#pragma once

#include "scenes.hpp"

#include <passive_haptics/runtime/any_design.hpp>
#include <passive_haptics/runtime/catalogue.hpp>

#include <algorithm>
#include <concepts>
#include <exception>
#include <memory>
#include <utility>

namespace passive_haptics_python {

/// A mechanism, and its functions of design; nullptr where its kind is not compiled.
struct mechanism {
  std::unique_ptr<rt::any_mechanism> held;  ///< The mechanism.
  std::unique_ptr<rt::any_design> design;   ///< Its functions.

  /// Holds this one.
  explicit mechanism(std::unique_ptr<rt::any_mechanism> of);
  rt::device_sizes sizes() const { return held->sizes(); }  ///< n, d and m.
  /// The functions; a TypeError where there are none.
  const rt::any_design& functions() const;
};

/// State of a device.
struct device_state {
  double time = 0;                 ///< [s]
  std::vector<double> q;           ///< n [rad or m]
  std::vector<double> qd;          ///< n [rad/s or m/s]
  std::vector<double> hand_force;  ///< d [N]; none without a force sensor.
  /// As a cycle takes it.
  operator rt::state_view() const { return {time, q, qd, hand_force}; }
};

/// A ValueError if the flag of an object is set: another call uses it. Else sets it while the result lives.
std::unique_ptr<bool, void (*)(bool*)> only_call(bool& is_called);

/// A controller that one call uses at a time: a function of a mechanism in Python might call it again.
class controller {
 public:
  /// Holds this one.
  explicit controller(std::unique_ptr<rt::any_controller> of) : held_(std::move(of)) {}
  /// One cycle. A ValueError if a vector has another size, or there is no hand force where the law needs one;
  /// throws what functions of a mechanism in Python throw.
  rt::cycle_record step(const rt::state_view& state);
  void reset() { only_call(is_called_), held_->reset(); }  ///< Forgets the motion.
  /// Other brakes from the next cycle on.
  void set_brakes(const rt::brake_numbers& brakes) { only_call(is_called_), held_->set_brakes(brakes); }
  const rt::any_controller& held() const { return *held_; }  ///< The controller.

 private:
  std::unique_ptr<rt::any_controller> held_;
  bool is_called_ = false;
};

/// Exceptions of a user's functions within a control cycle, which cannot throw: keeps the first one of this
/// thread while it lives.
class deferred_error {
 public:
  deferred_error() : outer_(std::exchange(innermost_, this)) {}  ///< Keeps exceptions from here on.
  deferred_error(const deferred_error&) = delete;
  deferred_error& operator=(const deferred_error&) = delete;
  ~deferred_error() { innermost_ = outer_; }
  /// Throws what was kept.
  void rethrow() {
    if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
  }
  /// True if an exception is kept, so that a function need not be called any more.
  static bool is_kept() { return innermost_ != nullptr && innermost_->error_ != nullptr; }
  /// Keeps the exception that is handled now, or throws it where none may be kept.
  static void keep() {
    if (innermost_ == nullptr) throw;
    if (innermost_->error_ == nullptr) innermost_->error_ = std::current_exception();
  }

 private:
  inline static thread_local deferred_error* innermost_ = nullptr;
  deferred_error* outer_;
  std::exception_ptr error_;
};

/// The elements f(k) of each row k, in this shape. Throws what functions of a mechanism in Python threw.
template <class T = double, class F>
py::array_t<T> by_rows(const rows_of& rows, const std::vector<py::ssize_t>& shape, const F& f) {
  deferred_error errors;
  auto all = results_for<T>(rows, shape);
  T* const first = all.mutable_data();
  for (py::ssize_t k = 0; k < rows.size(); ++k) {
    let_others_run(k);
    const auto& found = f(k);
    std::copy_n(found.data(), found.size(), first + k * all.size() / rows.size());
  }
  errors.rethrow();
  return all;
}

/// Runs the cycles of N states without Python's lock. Result: the arrays by their names, those of `out` where
/// it has them.
py::dict run_batch(const controller& of, py::handle q, py::handle qd, py::handle hand_force, py::handle time,
                   const py::list& fields, const py::dict& out, int workers);

// Each binds a part of the module.
void bind_scenes(py::module_& module);
void bind_devices(py::module_& module);
void bind_design(py::class_<mechanism>& bound);
void bind_simulations(py::module_& module);
void bind_python_mechanism(py::module_& module);

}  // namespace passive_haptics_python

namespace pybind11::detail {

/// States and results, which a user can get without their __init__, by X.__new__(X): using one is a
/// TypeError.
template <class T>
  requires std::same_as<T, passive_haptics_python::device_state> ||
           std::same_as<T, passive_haptics::runtime::cycle_record>
class type_caster<T> : public type_caster_base<T> {
 public:
  /// As of the base class.
  bool load(handle from, bool convert) {
    if (isinstance<T>(from) &&
        !reinterpret_cast<instance*>(from.ptr())->get_value_and_holder().holder_constructed())
      throw type_error("passive_haptics: a value without parameters: expected a call of its __init__");
    return type_caster_base<T>::load(from, convert);
  }
};

}  // namespace pybind11::detail
