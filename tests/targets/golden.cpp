// The same control cycles on every target, what each decides as bits. No inputs but integers, no output but
// text: it runs without an operating system as well.
//   golden            prints the results
//   golden margins    also asks the neighbours of each input: fails where one of them decides otherwise
#include "output.hpp"

#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/control/step.hpp>
#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>

#include <cmath>
#include <concepts>
#include <cstdint>

namespace ph = passive_haptics;

namespace {

constexpr int cases = 12;  // of each device, law and scalar
bool margins_asked = false, margins_kept = true;

// Multiples of 2^-20, the same in every arithmetic (Lehmer, modulo 2^31 - 1).
class numbers {
 public:
  double between(double lower, double upper) {
    state_ = state_ * 48271 % 2147483647;
    return lower + (upper - lower) * (static_cast<double>(state_ >> 11) / 1048576);
  }
  template <class T, int N>
  ph::vector<T, N> vector(double lower, double upper) {
    ph::vector<T, N> x;
    for (int i = 0; i < N; ++i) x[i] = static_cast<T>(between(lower, upper));
    return x;
  }

 private:
  std::uint64_t state_ = 20040627;
};

// Out of the wall
template <int D>
ph::point<D> direction(numbers& random) {
  const ph::point<D> x = random.vector<double, D>(-1, 1);
  return x / std::sqrt(x.squaredNorm());
}

template <class M>
struct input {
  ph::device_state<M> state;
  ph::contact<M::task_dimension> wall;
};

// Where the loop of every device closes
template <class M>
input<M> next_input(numbers& random) {
  using T = typename M::scalar;
  constexpr int n = M::dof, d = M::task_dimension;
  input<M> in;
  in.state.time = 0;
  in.state.q = random.vector<T, n>(0.3, 0.9);
  if constexpr (d == 2) in.state.q[0] += T(1);
  in.state.qd = random.vector<T, n>(-1, 1);
  in.state.hand_force = random.vector<T, d>(-2, 2);
  in.wall.normal = direction<d>(random);
  in.wall.depth = random.between(1e-4, 2e-3);
  in.wall.stiffness = 1000;
  in.wall.sensed_at.setZero();
  return in;
}

template <class M, class L>
ph::step_result<M> decide(const input<M>& in) {
  using T = typename M::scalar;
  ph::brakes_of<M> brakes;
  brakes.torque_limit.setConstant(T(0.25));
  ph::contacts<M::task_dimension, 1> touched;
  touched.push_back(in.wall);
  ph::step_memory<L> memory;
  return ph::step(M(), brakes, touched, L(), in.state, memory);
}

// What a rounding may not change
template <class M>
bool same_kind(const ph::step_result<M>& a, const ph::step_result<M>& b) {
  return a.outcome == b.outcome && a.power == b.power && a.display == b.display &&
         a.saturated == b.saturated && a.signs == b.signs && (a.alpha == 0) == (b.alpha == 0) &&
         (a.alpha == 1) == (b.alpha == 1);
}

template <class M, class L>
bool neighbours_agree(const input<M>& in, const ph::step_result<M>& here) {
  using T = typename M::scalar;
  constexpr int n = M::dof, d = M::task_dimension;
  const double apart = std::same_as<T, float> ? 1e-5 : 1e-9;
  numbers random;
  for (int k = 0; k < 8; ++k) {
    input<M> close_by = in;
    close_by.state.q += random.vector<T, n>(-apart, apart);
    close_by.state.qd += random.vector<T, n>(-apart, apart);
    close_by.state.hand_force += random.vector<T, d>(-apart, apart);
    close_by.wall.depth *= 1 + random.between(-apart, apart);
    if (!same_kind(decide<M, L>(close_by), here)) return false;
  }
  return true;
}

template <class M, class L>
void print_cases(const char* name) {
  using T = typename M::scalar;
  numbers random;
  for (int k = 0; k < cases; ++k) {
    const input<M> in = next_input<M>(random);
    const auto r = decide<M, L>(in);
    output::line line(name);
    line << std::same_as<T, float> << k << static_cast<int>(r.outcome) << static_cast<int>(r.power)
         << static_cast<int>(r.display) << r.saturated;
    for (const auto& x : {r.capacity, r.torque, r.cone_coefficients, r.signs})
      for (const T number : x) line << number;
    for (const auto& x : {r.desired_force, r.control_force})
      for (const T number : x) line << number;
    line << r.alpha << r.approximation_cosine;
    if (margins_asked && !neighbours_agree<M, L>(in, r)) {
      line << -1;
      margins_kept = false;
    }
  }
}

template <class T>
void print_devices() {
  using ph::direct_control, ph::velocity_direct_control;
  print_cases<ph::tendon_two_link<T>, direct_control>("tendon_two_link/direct");
  print_cases<ph::xy_table<T>, direct_control>("xy_table/direct");
  print_cases<ph::five_bar<T>, direct_control>("five_bar/direct");
  print_cases<ph::five_bar<T, 4>, direct_control>("five_bar_of_4/direct");
  print_cases<ph::delta<T>, direct_control>("delta/direct");
  print_cases<ph::tendon_two_link<T>, velocity_direct_control>("tendon_two_link/velocity");
}

}  // namespace

int main(int argc, char**) {
  margins_asked = argc > 1;
  print_devices<double>();
  print_devices<float>();
  return margins_kept ? 0 : 1;
}
