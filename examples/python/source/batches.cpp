// Batches of states, for controllers.py of the package.
#include "devices.hpp"

#include <algorithm>
#include <cstdint>
#include <future>
#include <thread>
#include <type_traits>
#include <vector>

namespace passive_haptics_python {
namespace {

// Column i of an array with elements of the size of T.
template <class T>
ph::strided_span<T> column(const py::array& array, py::ssize_t i) {
  const char* first = static_cast<const char*>(array.data()) + (array.ndim() == 1 ? 0 : i * array.strides(1));
  return {reinterpret_cast<T*>(const_cast<char*>(first)), static_cast<std::size_t>(array.shape(0)),
          array.strides(0) / static_cast<py::ssize_t>(sizeof(T))};
}
template <class T>
void use_array(const py::array& array, ph::strided_span<T>& numbers) {
  numbers = column<T>(array, 0);
}
template <class T, std::size_t Max>
void use_array(const py::array& array, std::array<ph::strided_span<T>, Max>& columns) {
  for (py::ssize_t i = 0; i < array.shape(1); ++i) ph::nth(columns, i) = column<T>(array, i);
}

// Sets the columns to the numbers of states, in place if they are aligned doubles; returns their array.
template <class Columns>
py::array use_numbers(const char* name, py::handle x, int rows, int width, Columns& columns) {
  const py::array array = matrix_from(x, name, rows, width);
  use_array(array, columns);
  return array;
}

template <class T>
const char* dtype_of(const ph::strided_span<T>&) {
  if (std::is_same_v<T, double>) return "float64";
  return std::is_same_v<T, std::uint8_t> ? "bool" : "int32";
}
template <class T, std::size_t Max>
const char* dtype_of(const std::array<ph::strided_span<T>, Max>& columns) {
  return dtype_of(columns[0]);
}

// The caller's array for a result, which is none of the inputs.
py::array checked(const std::string& name, const py::object& given, const py::object& type,
                  const py::object& shape, const py::dict& inputs) {
  const auto text = [](const py::object& dtype, const py::object& size, const char* access) {
    return std::string(py::str(dtype)) + " of shape " + std::string(py::str(size)) + ", " + access;
  };
  std::string found = shown(given), expected = text(type, shape, "writable");
  if (py::isinstance<py::array>(given))
    found = text(given.attr("dtype"), given.attr("shape"),
                 given.attr("flags").attr("behaved").cast<bool>() ? "writable" : "read-only or unaligned");
  if (found != expected)
    refuse_value("out." + name + " = " + found + ": expected an array of " + expected +
                 ": pass what batch() returned for as many states");
  const py::object may_share_memory = py::module_::import("numpy").attr("may_share_memory");
  for (const auto& [input, array] : inputs)
    if (may_share_memory(array, given).cast<bool>())
      refuse_value(std::string(py::str(input)) + " shares memory with out." + name +
                   ": expected other memory: pass " + std::string(py::str(input)) + ".copy()");
  return given;
}

}  // namespace

py::dict run_batch(const controller& of, py::handle q, py::handle qd, py::handle hand_force, py::handle time,
                   const py::list& fields, const py::dict& out, int workers) {
  const auto [n, d, m] = of.held().sizes();
  if (workers < 1 && workers != -1)
    refuse_value("workers = " + std::to_string(workers) +
                 ": expected at least 1, or -1: one for each processor");
  if (hand_force.is_none() && of.held().needs_hand_force())
    refuse_value("hand_force = None: expected an array of forces [N]: the law needs a hand force");
  rt::any_batch_states states;
  py::dict inputs;
  inputs["q"] = use_numbers("q", q, -1, n, states.q);
  const int size = static_cast<int>(states.size());
  inputs["qd"] = use_numbers("qd", qd, size, n, states.qd);
  if (!hand_force.is_none())
    inputs["hand_force"] = use_numbers("hand_force", hand_force, size, d, states.hand_force);
  std::vector<double> times;
  if (!time.is_none()) times = vector_from(time, "time", size);
  states.time = times;

  rt::any_batch_results results;
  py::dict stored;
  const auto use = [&]<class Columns>(const char* name, Columns& columns) {
    if (!fields.contains(name)) return;
    py::object shape = py::make_tuple(size), type = py::dtype(dtype_of(columns));
    if constexpr (requires { columns.front(); }) shape = py::make_tuple(size, columns.size() == 3 ? d : m);
    const py::array array = out.contains(name)
                                ? checked(name, out[name], type, shape, inputs)
                                : py::array(py::module_::import("numpy").attr("empty")(shape, type));
    use_array(array, columns);
    stored[name] = array;
  };
  use("capacity", results.capacity);
  use("outcome", results.outcome);
  for_each_optional(use, results);

  py::list references;  // NumPy does not resize an array with a weak reference
  for (const py::dict& arrays : {inputs, stored})
    for (const auto& [name, array] : arrays) references.append(py::weakref(array));
  const auto control = of.held().copy();
  const auto run = [&](std::size_t first, std::size_t count) {
    deferred_error errors;
    control->batch(part_of(states, first, count), part_of(results, first, count));
    errors.rethrow();
  };
  constexpr std::size_t states_between_signals = 1 << 16;
  const unsigned processors = std::max(1U, std::thread::hardware_concurrency());
  const unsigned threads = std::min(static_cast<unsigned>(workers), processors);  // -1 is the largest number
  {
    const py::gil_scoped_release unlocked;
    for (std::size_t k = 0; k < states.size();) {
      const std::size_t end = std::min(states.size(), k + threads * states_between_signals);
      std::vector<std::future<void>> parts;
      for (unsigned i = threads; i > 0; --i) {
        const std::size_t count = (end - k) / i;
        parts.push_back(std::async(threads == 1 ? std::launch::deferred : std::launch::async, run, k, count));
        k += count;
      }
      for (const auto& part : parts) part.wait();
      const py::gil_scoped_acquire locked;
      for (auto& part : parts) part.get();
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }
  }
  return stored;
}

}  // namespace passive_haptics_python
