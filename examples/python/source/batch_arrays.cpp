// The arrays of a batch.
#include <precompiled.hpp>

#include "batch_arrays.hpp"

#include <algorithm>

namespace passive_haptics_python {
namespace {

// What a result is stored as: an enumeration as whole numbers, saturated as bool, all else as double.
py::dtype dtype_of_field(const std::string& name) {
  if (name == "saturated") return py::dtype::of<bool>();
  for (const char* whole : {"outcome", "power", "display", "wall_number"})
    if (name == whole) return py::dtype::of<int>();
  return py::dtype::of<double>();
}

int width_of(char row, const device_sizes& sizes) {
  return row == 'm' ? sizes.brake_count : row == 'd' ? sizes.task_dimension : 1;
}

std::string shape_of(const py::array& x) { return py::str(x.attr("shape")); }

std::string expected_shape(py::ssize_t states, int width, bool is_row) {
  const std::string n = std::to_string(states);
  return is_row ? "(" + n + ", " + std::to_string(width) + ")" : "(" + n + ",)";
}

// Throws KeyboardInterrupt, or what another signal's handler does.
void check_signals() {
  const py::gil_scoped_acquire locked;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

template <class T>
std::vector<T*> moved(const std::vector<T*>& columns, std::size_t by) {
  std::vector<T*> all = columns;
  for (T*& column : all) column += by;
  return all;
}
template <class T>
T* moved(T* column, std::size_t by) {
  return column == nullptr ? nullptr : column + by;
}

// Where the results of states from `first` on go.
batch_columns part_of(const batch_columns& all, std::size_t first, std::size_t count) {
  batch_columns part;
  part.count = count;
  part.capacity = moved(all.capacity, first);
  part.outcome = moved(all.outcome, first);
  part.torque = moved(all.torque, first);
  part.power = moved(all.power, first);
  part.display = moved(all.display, first);
  part.saturated = moved(all.saturated, first);
  part.wall_number = moved(all.wall_number, first);
  part.alpha = moved(all.alpha, first);
  part.approximation_cosine = moved(all.approximation_cosine, first);
  part.desired_force = moved(all.desired_force, first);
  part.control_force = moved(all.control_force, first);
  part.cone_coefficients = moved(all.cone_coefficients, first);
  part.signs = moved(all.signs, first);
  return part;
}

template <class T>
T* data_of(const py::object& x) {
  return x.is_none() ? nullptr : static_cast<T*>(py::reinterpret_borrow<py::array>(x).mutable_data());
}
std::vector<double*> columns_in(const py::object& x) {
  std::vector<double*> all;
  if (x.is_none()) return all;
  const auto array = py::reinterpret_borrow<py::array>(x);
  for (py::ssize_t i = 0; i < array.shape(1); ++i) all.push_back(data_of<double>(x) + i * array.shape(0));
  return all;
}

void check_apart(const batch_values& results, const input_columns& states, const char* name) {
  if (!states.is_given()) return;
  const py::object share = py::module_::import("numpy").attr("may_share_memory");
  batch_values::for_each(results, [&](const char* field, const py::object& array, char) {
    if (!array.is_none() && py::cast<bool>(share(array, states.array())))
      refuse_value(std::string(name) + " shares memory with out." + field + ", expected other memory: pass " +
                   name + ".copy()");
  });
}

}  // namespace

input_columns::input_columns(py::handle x, const char* name, int width, const char* what) {
  if (!py::isinstance<py::array>(x))
    refuse_type(std::string(name) + " = " + shown(x) + ", expected a numpy.ndarray of float64, " + what +
                ": numpy.array(" + name + ", dtype=float)");
  array_ = plain_array(x, name);
  if (!array_.dtype().is(py::dtype::of<double>()) &&
      py::cast<std::string>(array_.dtype().attr("str")) != "<f8")
    refuse_type(std::string(name) + " has dtype " + dtype_of(array_) + ", expected float64: " + name +
                ".astype(float)");
  const bool is_row = width > 0;
  if (array_.ndim() != (is_row ? 2 : 1) || (is_row && array_.shape(1) != width))
    refuse_value("shape of " + std::string(name) + " = " + shape_of(array_) + ", expected " +
                 (is_row ? "(N, " + std::to_string(width) + ")" : "(N,)") + ", " + what);
  columns_ = is_row ? width : 1;
  const bool is_aligned = reinterpret_cast<std::uintptr_t>(array_.data()) % alignof(double) == 0 &&
                          (!is_row || array_.strides(1) % py::ssize_t(alignof(double)) == 0);
  in_place_ = is_aligned && (array_.shape(0) <= 1 || array_.strides(0) == py::ssize_t(sizeof(double)));
}

std::vector<const double*> input_columns::from(std::size_t first, std::size_t count,
                                               std::vector<double>& buffer) const {
  std::vector<const double*> all;
  if (!is_given()) return all;
  const auto width = std::size_t(columns_);
  if (!in_place_) buffer.resize(width * count);
  const py::ssize_t step = array_.strides(0), across = columns_ > 1 ? array_.strides(1) : 0;
  for (std::size_t i = 0; i < width; ++i) {
    const char* from =
        static_cast<const char*>(array_.data()) + py::ssize_t(first) * step + py::ssize_t(i) * across;
    if (in_place_) {
      all.push_back(reinterpret_cast<const double*>(from));
      continue;
    }
    double* to = buffer.data() + i * count;
    all.push_back(to);
    for (std::size_t k = 0; k < count; ++k, from += step) std::memcpy(to + k, from, sizeof(double));
  }
  return all;
}

batch_values new_results(const device_sizes& sizes, py::ssize_t states, const py::object& fields) {
  std::vector<std::string> names, wanted;
  batch_values results;
  batch_values::for_each(results, [&](const char* name, py::object&, char) { names.emplace_back(name); });
  const bool all = fields.is_none();
  if (!all) {
    if (PyUnicode_Check(fields.ptr()) || !py::isinstance<py::iterable>(fields))
      refuse_type("fields = " + shown(fields) + ", expected a list of names, or None for all");
    for (const py::handle field : fields) {
      if (!PyUnicode_Check(field.ptr()) ||
          std::find(names.begin(), names.end(), py::cast<std::string>(field)) == names.end()) {
        std::string text;
        for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
        refuse_value("fields has " + shown(field) + ", expected names among " + text);
      }
      wanted.push_back(py::cast<std::string>(field));
    }
    wanted.insert(wanted.end(), {"capacity", "outcome"});
  }
  batch_values::for_each(results, [&](const char* name, py::object& array, char row) {
    array = py::none();
    if (!all && std::find(wanted.begin(), wanted.end(), name) == wanted.end()) return;
    const py::dtype type = dtype_of_field(name);
    // Column by column, as the batch stores them
    if (row == '1') array = py::array(type, std::vector<py::ssize_t>{states});
    else
      array = py::array(
          type, std::vector<py::ssize_t>{states, width_of(row, sizes)},
          std::vector<py::ssize_t>{type.itemsize(), type.itemsize() * std::max<py::ssize_t>(states, 1)});
  });
  return results;
}

batch_columns columns_of(const batch_values& results, const device_sizes& sizes, py::ssize_t states) {
  batch_values::for_each(results, [&](const char* name, const py::object& x, char row) {
    if (x.is_none()) return;
    const auto array = py::reinterpret_borrow<py::array>(x);
    const int width = width_of(row, sizes);
    const std::string expected = expected_shape(states, width, row != '1');
    if (shape_of(array) != expected)
      refuse_value(std::string("shape of out.") + name + " = " + shape_of(array) + ", expected " + expected +
                   ": pass a result of as many states of this device");
    if (!array.writeable())
      refuse_value(std::string("out.") + name + " is read-only, expected an array that can be written");
    if (!array.dtype().is(dtype_of_field(name)) || (array.flags() & py::array::f_style) == 0)
      refuse_value(std::string("out.") + name + " is not an array of ours, expected what batch() returned");
  });
  return {.count = std::size_t(states),
          .q = {},
          .qd = {},
          .hand_force = {},
          .time = nullptr,
          .capacity = columns_in(results.capacity),
          .outcome = data_of<ph::status>(results.outcome),
          .torque = columns_in(results.torque),
          .power = data_of<ph::power_class>(results.power),
          .display = data_of<ph::display_class>(results.display),
          .saturated = data_of<std::uint8_t>(results.saturated),
          .wall_number = data_of<int>(results.wall_number),
          .alpha = data_of<double>(results.alpha),
          .approximation_cosine = data_of<double>(results.approximation_cosine),
          .desired_force = columns_in(results.desired_force),
          .control_force = columns_in(results.control_force),
          .cone_coefficients = columns_in(results.cone_coefficients),
          .signs = columns_in(results.signs)};
}

batch_values run_batch(const any_batch& batch, const device_sizes& sizes, py::handle q, py::handle qd,
                       py::handle hand_force, py::handle time, const py::object& fields,
                       const py::object& out) {
  const input_columns joints(q, "q", sizes.dof, "a row of joint positions for each state");
  const input_columns rates(qd, "qd", sizes.dof, "a row of joint rates for each state");
  input_columns forces, times;
  if (!hand_force.is_none())
    forces = input_columns(hand_force, "hand_force", sizes.task_dimension, "a row of forces for each state");
  if (!time.is_none()) times = input_columns(time, "time", 0, "a number for each state");
  const py::ssize_t states = joints.rows();
  const auto check_rows = [&](const input_columns& x, const char* name) {
    if (x.is_given() && x.rows() != states)
      refuse_value(std::string("number of rows of ") + name + " = " + std::to_string(x.rows()) +
                   ", expected " + std::to_string(states) + ", as q has");
  };
  check_rows(rates, "qd");
  check_rows(forces, "hand_force");
  check_rows(times, "time");
  if (!out.is_none() && !fields.is_none())
    refuse_type("fields and out were both given, expected one of them: out has its fields already");
  const batch_values results =
      out.is_none() ? new_results(sizes, states, fields)
                    : expect<batch_values>(out, "out", "what batch() returned for as many states");
  const batch_columns all = columns_of(results, sizes, states);
  if (!out.is_none()) {
    check_apart(results, joints, "q");
    check_apart(results, rates, "qd");
    check_apart(results, forces, "hand_force");
    check_apart(results, times, "time");
  }

  const bool in_place =
      joints.is_in_place() && rates.is_in_place() && forces.is_in_place() && times.is_in_place();
  const std::size_t part_size = in_place ? 1u << 14 : 1u << 9;  // copies stay in the processor's cache
  constexpr std::size_t states_between_signals = 1u << 16;
  const py::gil_scoped_release unlocked;
  std::vector<double> buffer_q, buffer_qd, buffer_force, buffer_time;
  for (std::size_t first = 0; first < all.count; first += part_size) {
    const std::size_t count = std::min(part_size, all.count - first);
    batch_columns part = part_of(all, first, count);
    part.q = joints.from(first, count, buffer_q);
    part.qd = rates.from(first, count, buffer_qd);
    part.hand_force = forces.from(first, count, buffer_force);
    const std::vector<const double*> time_column = times.from(first, count, buffer_time);
    part.time = time_column.empty() ? nullptr : time_column[0];
    batch.run(part);
    if (first > 0 && first % states_between_signals == 0) check_signals();
  }
  return results;
}

}  // namespace passive_haptics_python
