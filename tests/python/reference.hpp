// The cycles of C++ with which those of Python are compared: of one device, under each of its laws.
#pragma once

#include <passive_haptics/control/batch_results.hpp>
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/laws/recommended_law.hpp>
#include <passive_haptics/control/laws/saturated_direct_control.hpp>
#include <passive_haptics/control/pipelines/several_walls.hpp>
#include <passive_haptics/scene/scene.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace reference {

namespace ph = passive_haptics;

// Doubles of a file, one after the other: a point of the wall, its normal and stiffness, the limits of the
// brakes, then time, q, qd and hand force of each state.
class doubles_in {
 public:
  explicit doubles_in(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    all_.resize(bytes.size() / sizeof(double));
    std::memcpy(all_.data(), bytes.data(), all_.size() * sizeof(double));
    if (all_.empty()) throw std::runtime_error("no states in " + path);
  }
  bool at_end() const { return next_ == all_.size(); }
  double number() { return all_.at(next_++); }
  template <int N>
  ph::vector<double, N> numbers() {
    ph::vector<double, N> v;
    for (int i = 0; i < N; ++i) v[i] = number();
    return v;
  }

 private:
  std::vector<double> all_;
  std::size_t next_ = 0;
};

// Doubles to a file.
class doubles_out {
 public:
  explicit doubles_out(const std::string& path) : file_(path, std::ios::binary) {}
  void add(double x) { file_.write(reinterpret_cast<const char*>(&x), sizeof x); }
  template <int N>
  void add(const ph::vector<double, N>& v) {
    for (int i = 0; i < N; ++i) add(v[i]);
  }
  template <class R>
  void add_result(const R& r) {
    add(r.capacity);
    add(r.torque);
    for (const int whole : {static_cast<int>(r.outcome), static_cast<int>(r.power),
                            static_cast<int>(r.display), static_cast<int>(r.saturated), r.wall_number})
      add(double(whole));
    add(r.alpha);
    add(r.approximation_cosine);
    add(r.desired_force);
    add(r.control_force);
    add(r.cone_coefficients);
    add(r.signs);
  }

 private:
  std::ofstream file_;
};

// What all cycles of a file have in common, and their states.
template <class M>
struct task {
  explicit task(const std::string& path) : task(doubles_in(path)) {}
  explicit task(doubles_in in) {
    point = in.numbers<M::task_dimension>();
    normal = in.numbers<M::task_dimension>();
    stiffness = in.number();
    brakes.torque_limit = in.numbers<M::brake_count>();
    while (!in.at_end()) {
      ph::device_state<M> s;
      s.time = in.number();
      s.q = in.numbers<M::dof>();
      s.qd = in.numbers<M::dof>();
      s.hand_force = in.numbers<M::task_dimension>();
      states.push_back(s);
    }
  }
  auto scene() const {
    return ph::scene(ph::wall(ph::half_space<M::task_dimension>(point, normal), stiffness));
  }

  ph::point<M::task_dimension> point, normal;
  double stiffness = 0;
  ph::brakes_of<M> brakes;
  std::vector<ph::device_state<M>> states;
};

// N numbers for each component.
template <int Components>
struct columns {
  std::array<std::vector<double>, std::size_t(Components)> of;
  explicit columns(std::size_t n) { of.fill(std::vector<double>(n)); }
  template <class T = double>
  ph::component_arrays<T, Components> spans() {
    ph::component_arrays<T, Components> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = of[i];
    return all;
  }
};

// The results of a batch, as those of single cycles are written.
template <class M, class C>
void write_batch(const C& control, const std::vector<ph::device_state<M>>& states, doubles_out& out) {
  constexpr int n = M::dof, d = M::task_dimension, m = M::brake_count;
  const std::size_t N = states.size();
  columns<n> q(N), qd(N);
  columns<d> force(N), desired(N), approximated(N);
  columns<m> capacity(N), torque(N), coefficients(N), signs(N);
  std::vector<double> time(N), alpha(N), cosine(N);
  std::vector<ph::status> outcome(N);
  std::vector<ph::power_class> power(N);
  std::vector<ph::display_class> display(N);
  std::vector<std::uint8_t> saturated(N);
  std::vector<int> wall_number(N);
  for (std::size_t k = 0; k < N; ++k) {
    time[k] = states[k].time;
    for (int i = 0; i < n; ++i)
      q.of[std::size_t(i)][k] = states[k].q[i], qd.of[std::size_t(i)][k] = states[k].qd[i];
    for (int i = 0; i < d; ++i) force.of[std::size_t(i)][k] = states[k].hand_force[i];
  }
  control.batch(ph::batch_states<M>{q.template spans<const double>(), qd.template spans<const double>(),
                                    force.template spans<const double>(), time},
                ph::batch_results<M>{capacity.spans(), outcome, torque.spans(), power, display, saturated,
                                     wall_number, alpha, cosine, desired.spans(), approximated.spans(),
                                     coefficients.spans(), signs.spans()});
  const auto row = [&]<int Size>(const columns<Size>& c, std::size_t k) {
    ph::vector<double, Size> v;
    for (int i = 0; i < Size; ++i) v[i] = c.of[std::size_t(i)][k];
    return v;
  };
  for (std::size_t k = 0; k < N; ++k) {
    ph::step_result<M> r;
    r.capacity = row(capacity, k), r.torque = row(torque, k), r.outcome = outcome[k], r.power = power[k];
    r.display = display[k], r.saturated = saturated[k] != 0, r.wall_number = wall_number[k],
    r.alpha = alpha[k];
    r.approximation_cosine = cosine[k], r.desired_force = row(desired, k),
    r.control_force = row(approximated, k);
    r.cone_coefficients = row(coefficients, k), r.signs = row(signs, k);
    out.add_result(r);
  }
}

// Single cycles one after the other, with what the law remembers, or a batch.
template <class M, class L>
void run(const M& mechanism, const L& law, const std::string& mode, const std::string& in,
         const std::string& to) {
  const task<M> given(in);
  doubles_out out(to);
  ph::controller control(mechanism, given.brakes, given.scene(), law);
  if (mode == "batch") write_batch<M>(control, given.states, out);
  else
    for (const auto& state : given.states) out.add_result(control(state));
}

// By the name of the law; the recommended one is called so. Returns whether there is such a law.
template <class M>
bool run_law(const M& mechanism, const std::string& law, const std::string& mode, const std::string& in,
             const std::string& to) {
  if (law == "direct_control") return run(mechanism, ph::direct_control(), mode, in, to), true;
  if (law == "saturated_direct_control")
    return run(mechanism, ph::saturated_direct_control(), mode, in, to), true;
  if (law == "recommended") {
    const task<M> given(in);
    return run(mechanism, ph::recommended_law(mechanism, given.brakes), mode, in, to), true;
  }
  return false;
}

// Runs a law of a device of this file; false if the device is another one.
bool run_device(const std::string& device, const std::string& law, const std::string& mode,
                const std::string& in, const std::string& to);
bool run_design(const std::string& device, const std::string& law, const std::string& mode,
                const std::string& in, const std::string& to);
bool run_scene(const std::string& device, const std::string& law, const std::string& mode,
               const std::string& in, const std::string& to);
bool run_log(const std::string& device, const std::string& law, const std::string& mode,
             const std::string& in, const std::string& to);

}  // namespace reference
