/// @file
/// Runs a logged motion through a control law, line by line.
#pragma once

#include <passive_haptics/passive_haptics.hpp>

#include "log_reader.hpp"

#include <array>
#include <charconv>
#include <concepts>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace example {

namespace ph = passive_haptics;

/// A wall whose shape is chosen at run time: itself a Shape.
template <int D>
class any_wall {
 public:
  static constexpr int dimension = D;

  /// Takes on the shape of s.
  template <ph::Shape S>
    requires(!std::same_as<S, any_wall>)
  explicit any_wall(const S& s)
      : distance_([s](const ph::point<D>& x) { return s.distance(x); }),
        gradient_([s](const ph::point<D>& x) { return s.gradient(x); }) {}

  double distance(const ph::point<D>& x) const { return distance_(x); }
  ph::point<D> gradient(const ph::point<D>& x) const { return gradient_(x); }

 private:
  std::function<double(const ph::point<D>&)> distance_;
  std::function<ph::point<D>(const ph::point<D>&)> gradient_;
};

/// Appends numbers and words to a line of CSV; the shortest text that reads back as the same number.
class csv_line {
 public:
  void add(std::string_view word) { (text_ += word) += ','; }
  void add(double value) {
    std::array<char, 32> digits;
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    add(std::string_view(digits.data(), static_cast<std::size_t>(end - digits.data())));
  }
  template <class Vector>
    requires requires(const Vector v) {
      v.size();
      v[0];
    } && (!std::convertible_to<Vector, std::string_view>)
  void add(const Vector& values) {
    for (int i = 0; i < values.size(); ++i) add(static_cast<double>(values[i]));
  }
  /// Writes the line and starts a new one.
  void end(std::ostream& out) {
    text_.back() = '\n';
    out.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
  }

 private:
  std::string text_;
};

inline void add_names(std::vector<std::string>& names, const std::string& stem, int count) {
  for (int i = 1; i <= count; ++i) names.push_back(stem + std::to_string(i));
}
inline void add_axes(std::vector<std::string>& names, const std::string& stem, int count) {
  for (int i = 0; i < count; ++i) names.push_back(stem + "_" + "xyz"[i]);
}

/// Columns of a log of mechanism M.
template <class M>
std::vector<std::string> log_columns() {
  std::vector<std::string> names{"t"};
  add_names(names, "q", M::dof);
  add_names(names, "qd", M::dof);
  add_axes(names, "Fh", M::task_dimension);
  return names;
}

/// Columns of what a replay writes.
template <class M>
std::vector<std::string> replay_columns() {
  std::vector<std::string> names{"t", "power", "display", "gamma", "alpha"};
  add_axes(names, "Fd", M::task_dimension);
  add_axes(names, "Fc", M::task_dimension);
  add_names(names, "capacity", M::brake_count);
  add_names(names, "torque", M::brake_count);
  names.push_back("status");
  return names;
}

/// Reads a log from `in`, runs each line through the law and writes the decisions to `out`. The number of
/// lines. Memory does not grow with the log. Throws log_error on the first malformed line. `progress` hears
/// the number of lines done, every 65 536 of them.
template <class M, class Law>
std::size_t replay(std::istream& in, std::ostream& out, const M& mechanism, const ph::brakes_of<M>& brakes,
                   const ph::wall<any_wall<M::task_dimension>>& wall, const Law& law,
                   const std::function<void(std::size_t)>& progress = {}) {
  ph::controller control(mechanism, brakes, ph::scene(wall), law);
  log_reader log(in, log_columns<M>());
  csv_line line;
  for (const auto& name : replay_columns<M>()) line.add(name);
  line.end(out);

  std::size_t lines = 0;
  while (const std::vector<double>* values = log.next()) {
    ph::device_state<M> state;
    const double* value = values->data();
    state.time = *value++;
    for (auto& q : state.q) q = *value++;
    for (auto& qd : state.qd) qd = *value++;
    for (auto& f : state.hand_force) f = *value++;
    const auto r = control(state);
    line.add(state.time);
    line.add(to_string(r.power));
    line.add(to_string(r.display));
    line.add(r.approximation_angle());
    line.add(r.alpha);
    line.add(r.desired_force);
    line.add(r.control_force);
    line.add(r.capacity);
    line.add(r.torque);
    line.add(to_string(r.outcome));
    line.end(out);
    if (++lines % 65536 == 0 && progress) progress(lines);
  }
  return lines;
}

}  // namespace example
