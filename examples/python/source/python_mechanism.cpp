// A mechanism whose functions are written in Python.
#include <precompiled.hpp>

#include "mechanisms/any_devices.hpp"
#include "module.hpp"
#include "python_functions.hpp"

#include <passive_haptics_python/mechanisms.hpp>

#include <functional>

namespace passive_haptics_python {
namespace {

using check_at = std::function<void(const numbers& q)>;

// Lets exceptions of the mechanism's functions out of a control cycle. Such a function, and another thread
// while it runs, may call the controller again, which no cycle expects. The functions are checked at the
// first finite q.
class python_controller final : public any_controller {
 public:
  python_controller(std::unique_ptr<any_controller> held, check_at check)
      : held_(std::move(held)), check_(std::move(check)) {}
  result_values step(const state_values& state) override {
    const only_call alone(*this);
    check_first(state.q);
    deferred_error errors;
    const result_values result = held_->step(state);
    errors.rethrow();
    return result;
  }
  void run(const batch_columns& columns) const override {
    const py::gil_scoped_acquire locked;
    numbers q(static_cast<Eigen::Index>(columns.q.size()));
    for (std::size_t k = 0; check_ && k < columns.count; ++k) {
      for (std::size_t i = 0; i < columns.q.size(); ++i) q[static_cast<Eigen::Index>(i)] = columns.q[i][k];
      check_first(q);
    }
    deferred_error errors;
    held_->run(columns);
    errors.rethrow();
  }
  void reset() override {
    const only_call alone(*this);
    held_->reset();
  }
  void set_brakes(const brake_numbers& brakes) override {
    const only_call alone(*this);
    held_->set_brakes(brakes);
  }

 private:
  // Under Python's lock, as all calls but batches, which have a controller of their own.
  class only_call {
   public:
    explicit only_call(python_controller& of) : of_(of) {
      if (of.is_called_)
        refuse_value(
            "the controller is called while a function of its mechanism runs, expected one call at a "
            "time: make a controller for each thread, and call none from such a function");
      of.is_called_ = true;
    }
    only_call(const only_call&) = delete;
    only_call& operator=(const only_call&) = delete;
    ~only_call() { of_.is_called_ = false; }

   private:
    python_controller& of_;
  };

  void check_first(const numbers& q) const {
    if (!check_ || !q.allFinite()) return;
    check_at(check_)(q);  // a copy: another thread may be the first to end
    check_ = nullptr;
  }

  std::unique_ptr<any_controller> held_;
  bool is_called_ = false;
  mutable check_at check_;  // until it was passed
};

// The mechanism that recommended_law sees: brakes and no inertia.
struct massless_joint {
  using scalar = double;
  static constexpr int dof = 1, task_dimension = 1, brake_count = 1;
  ph::vector<double, 1> position(const ph::vector<double, 1>& q) const { return q; }
};

py::object recommended_relay(const brake_numbers& brakes) {
  ph::brakes_of<massless_joint> slowest;
  slowest.time_constant.setConstant(brakes.time_constant.maxCoeff());
  return py::cast(law_value<ph::on_off_control>(ph::recommended_law(massless_joint(), slowest).parameters));
}

struct size_of_device {
  int dof, task_dimension;
  bool has_inertia;  // whether simulations are compiled for this size
};
constexpr size_of_device sizes[] = {{2, 2, true}, {3, 2, true},  {4, 2, true},
                                    {3, 3, true}, {6, 3, false}, {7, 3, false}};

struct checked_device {
  std::unique_ptr<any_device> device;
  check_at check;
};

template <class Held, int N, int D>
checked_device device_of_functions(const callables& of, bool has_inertia) {
  const python_functions<N, D> functions(of);
  check_at check;
  if (!of.is_checked) check = [functions](const numbers& q) { functions.check(sized<N>(q, "q", "joints")); };
  return {device_for(Held(functions), has_inertia), std::move(check)};
}
checked_device device_of_size(int n, int d, const callables& of, bool has_inertia) {
  if (n == 2 && d == 2) return device_of_functions<any_pair, 2, 2>(of, has_inertia);
  if (n == 3 && d == 2) return device_of_functions<any_mechanism<3, 2>, 3, 2>(of, has_inertia);
  if (n == 4 && d == 2) return device_of_functions<any_mechanism<4, 2>, 4, 2>(of, has_inertia);
  if (n == 3 && d == 3) return device_of_functions<any_mechanism<3, 3>, 3, 3>(of, has_inertia);
  if (n == 6 && d == 3) return device_of_functions<any_long_chain<6>, 6, 3>(of, has_inertia);
  if (n == 7 && d == 3) return device_of_functions<any_long_chain<7>, 7, 3>(of, has_inertia);
  std::string all;
  for (const auto& size : sizes)
    all +=
        (all.empty() ? "" : ", ") + std::to_string(size.dof) + " and " + std::to_string(size.task_dimension);
  refuse_value("dof = " + std::to_string(n) + " and task_dimension = " + std::to_string(d) + ", expected " +
               all + "; bind a mechanism of another size in C++, with bind_mechanism");
}

// The parameters of a python_mechanism: two sizes, then functions.
const char* const names_of_inertia[] = {"mass_matrix", "bias_torque", "bias_acceleration"};

class python_mechanism final : public mechanism {
 public:
  const any_device& device() const override { return *of_.device; }
  std::unique_ptr<any_controller> make_controller(const brake_numbers& brakes, const scene& walls,
                                                  const py::object& of_law,
                                                  const ph::step_options<double>& options) const override {
    std::unique_ptr<any_controller> made;
    if (has_inertia_ || !py::isinstance<law_value<ph::velocity_direct_control>>(of_law))
      made = of_.device->make_controller(brakes, walls, py::cast<const law&>(of_law), options, nullptr);
    if (!made)
      refuse_type(
          "law = " + shown(of_law) + ", expected direct_control, saturated_direct_control, on_off_control" +
          (has_inertia_ ? " or velocity_direct_control" : "; velocity_direct_control needs a mass_matrix"));
    return std::make_unique<python_controller>(std::move(made), of_.check);
  }
  py::object recommended_law(const brake_numbers& brakes) const override {
    if (has_inertia_) return py::cast(law_value<ph::velocity_direct_control>());
    return recommended_relay(brakes);
  }
  // The brakes of as many joints.
  py::object brakes(const py::args& args, const py::kwargs& kwargs) const {
    const std::string name = "brakes_" + std::to_string(of_.device->sizes().brake_count);
    return py::module_::import("passive_haptics._native").attr(name.c_str())(*args, **kwargs);
  }

  static std::vector<std::string> names() {
    return {"dof",         "task_dimension", "position",          "jacobian",
            "mass_matrix", "bias_torque",    "bias_acceleration", "check"};
  }
  static python_mechanism made(const py::dict& given, const std::string& name) {
    python_mechanism m;
    for (const auto& [key, value] : given) m.set(py::str(key), value, name);
    for (const char* needed : {"dof", "task_dimension", "position"})
      if (!m.given_.contains(needed))
        refuse_type(name + " needs dof, task_dimension and position, but no " + needed + " was given");
    m.find_inertia();
    const int n = int(whole_number_from(m.given_["dof"], "dof"));
    const int d = int(whole_number_from(m.given_["task_dimension"], "task_dimension"));
    for (const auto& size : sizes)
      if (m.has_inertia_ && size.dof == n && size.task_dimension == d && !size.has_inertia)
        refuse_type("mass_matrix of a mechanism with " + std::to_string(n) +
                    " joints, expected none: simulations are for 2 to 4 joints; bind this one in C++, with "
                    "bind_mechanism");
    const bool is_trusted = m.given_.contains("check") && !py::bool_(m.given_["check"]);
    m.of_ = device_of_size(n, d,
                           {m.part("position"), m.part("jacobian"), m.part("mass_matrix"),
                            m.part("bias_torque"), m.part("bias_acceleration"), is_trusted},
                           m.has_inertia_);
    return m;
  }
  py::dict parameters() const { return py::dict(given_.attr("copy")()); }
  py::dict changed() const { return parameters(); }

 private:
  void set(const std::string& key, py::handle value, const std::string& name) {
    const std::vector<std::string> all = names();
    if (std::find(all.begin(), all.end(), key) == all.end())
      refuse_type(name + " has no parameter '" + key + "', expected " + joined(all));
    if (value.is_none()) return;
    if (key == "check") {
      if (!py::isinstance<py::bool_>(value))
        refuse_type("check = " + shown(value) + ", expected True or False");
    } else if (key == "dof" || key == "task_dimension") whole_number_from(value, key);
    else if (PyCallable_Check(value.ptr()) == 0)
      refuse_type(key + " = " + shown(value) + ", expected a function of q" +
                  (key.starts_with("bias") ? " and qd" : ""));
    given_[key.c_str()] = value;
  }
  void find_inertia() {
    int count = 0;
    for (const char* one : names_of_inertia) count += given_.contains(one) ? 1 : 0;
    for (const char* one : names_of_inertia)
      if (count > 0 && !given_.contains(one))
        refuse_type(std::string(one) +
                    " = None, expected a function: inertia takes mass_matrix, bias_torque and "
                    "bias_acceleration, all or none");
    has_inertia_ = count > 0;
  }
  py::object part(const char* key) const {
    return given_.contains(key) ? py::object(given_[key]) : py::none();
  }

  py::dict given_;
  bool has_inertia_ = false;
  checked_device of_;
};

// "python_mechanism(dof=2, ...)", functions by their names.
std::string shown_call(const python_mechanism& m) {
  std::string text;
  for (const auto& [key, value] : m.parameters()) {
    const py::object what = py::hasattr(value, "__qualname__") ? value.attr("__qualname__") : py::repr(value);
    text += (text.empty() ? "" : ", ") + std::string(py::str(key)) + "=" + std::string(py::str(what));
  }
  return "python_mechanism(" + text + ")";
}

}  // namespace

void bind_python_mechanism(py::module_& module) {
  using X = python_mechanism;
  py::class_<X, mechanism> bound(
      module, "python_mechanism",
      "(dof: int, task_dimension: int, position: Callable[[Array], Numbers], jacobian: Callable[[Array], "
      "Rows] | None = ..., mass_matrix: Callable[[Array], Rows] | None = ..., bias_torque: "
      "Callable[[Array, Array], Numbers] | None = ..., bias_acceleration: Callable[[Array, Array], "
      "Numbers] | None = ..., check: bool = ...)\n\nA mechanism whose functions are written in Python, a "
      "brake on each of its "
      "joints. It does all that a compiled one does, slower: each call of a function takes "
      "microseconds.\n\ndof and task_dimension: 2 and 2, 3 and 2, 4 and 2, 3 and 3, 6 and 3, or 7 and 3. "
      "position(q) returns the end effector [m], base frame, of joint positions q [rad or m], an array of "
      "dof numbers. jacobian(q) returns J in v = J qd, task_dimension x dof [m/rad or 1]; without it J is "
      "found by central differences, to about ten digits. With inertia, up to 4 joints: mass_matrix(q) "
      "returns M, dof x dof [kg m^2, kg m or kg], bias_torque(q, qd) returns c in M qdd + c [N m or N], "
      "bias_acceleration(q, qd) returns Jd qd [m/s^2]; all three or none. At the first q, the functions are "
      "compared with each other; a jacobian that is not the derivative of position (1e-4), a mass matrix "
      "that "
      "is not symmetric and positive definite, or a torque or acceleration that is not finite is a "
      "ValueError "
      "with the entry; check=False turns this off. An exception of a function comes "
      "out of the call as it is. NaN ends a cycle with status.state_not_finite or another status. The "
      "mechanism pickles if its functions do. Equal mechanisms have equal functions.");
  add_value_protocol(bound, "python_mechanism");
  bound.attr("__repr__") = py::cpp_function(&shown_call, py::name("__repr__"), py::is_method(bound));
  bound.def(
      "brakes", &X::brakes,
      "brakes(self, torque_limit: Numbers = ..., rate_dead_band: Numbers = ..., torque_dead_band: Numbers "
      "= ..., time_constant: Numbers = ..., torque_lower: Numbers = ..., torque_upper: Numbers = ...) -> "
      "brake_parameters\n\nThe brakes of this device: torque_limit "
      "[N m], rate_dead_band [rad/s], torque_dead_band [N m], time_constant [s], torque_lower and "
      "torque_upper [N m], a number for each joint.");
}

}  // namespace passive_haptics_python
