// libFuzzer: bytes become a device and all that a step is told, and no law may break.
#include "../stress/broken_law.hpp"
#include "input.hpp"

#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <limits>

namespace {

namespace ph = passive_haptics;

using fuzz::reader;

// Any constant Jacobian, of entries that are 0 or 1e-100 ... 1e100: the squares of no column may underflow.
struct any_jacobian {
  using scalar = double;
  static constexpr int dof = 3, task_dimension = 3, brake_count = 3;
  ph::matrix<double, 3, 3> J;
  ph::vector<double, 3> position(const ph::vector<double, 3>& q) const { return J * q; }
  ph::matrix<double, 3, 3> jacobian() const { return J; }
};

template <class L, class M>
void cycle(const M& mechanism, reader& in) {
  using T = typename M::scalar;
  constexpr int d = M::task_dimension;
  const std::uint8_t choice = in.byte();
  ph::device_state<M> state;
  state.time = 0;
  in.fill(state.q);
  in.fill(state.qd);
  in.fill(state.hand_force);
  ph::contacts<d, 2> touched;
  for (int j = 0; j <= (choice & 1); ++j) {
    ph::contact<d> wall;
    in.fill(wall.normal);
    if (choice & 2) wall.normal.stableNormalize();
    wall.depth = in.number();
    wall.stiffness = in.number();
    if (choice & 4) in.fill(wall.wall_velocity);
    touched.push_back(wall);
  }
  ph::brakes_of<M> brakes;
  if (choice & 8) in.fill(brakes.torque_limit);
  if (choice & 16) in.fill(brakes.rate_dead_band);
  if (choice & 32) in.fill(brakes.torque_dead_band);
  ph::step_options<T> options;
  if (choice & 64) options.min_cosine = static_cast<T>(in.number());
  if (choice & 128) options.limits = ph::saturation::clamp_each;

  ph::step_memory<L> memory;
  const auto result = ph::step(mechanism, brakes, touched, L{}, state, memory, options);
  if (const char* law = stress::broken_law(mechanism, brakes, state, touched.size(), result)) {
    std::cout.precision(17);
    std::cout << law << ", but q " << state.q.transpose() << ", qd " << state.qd.transpose()
              << ", hand force " << state.hand_force.transpose() << ", torque limit "
              << brakes.torque_limit.transpose() << ", rate dead band " << brakes.rate_dead_band.transpose()
              << ", torque dead band " << brakes.torque_dead_band.transpose() << ", min cosine "
              << options.min_cosine;
    for (const auto& wall : touched) {
      std::cout << "; normal " << wall.normal.transpose() << ", depth " << wall.depth << ", stiffness "
                << wall.stiffness << ", wall velocity " << wall.wall_velocity.transpose();
    }
    std::cout << ": torque " << result.torque.transpose() << ", capacity " << result.capacity.transpose()
              << ", control force " << result.control_force.transpose() << ", coefficients "
              << result.cone_coefficients.transpose() << ", cosine " << result.approximation_cosine << ", "
              << to_string(result.display) << std::endl;
    std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  reader in(data, size);
  switch (in.byte() % 5) {
    case 0: cycle<ph::direct_control>(ph::tendon_two_link<double>(), in); break;
    case 1: cycle<ph::no_direct_control>(ph::tendon_two_link<double>(), in); break;
    case 2: cycle<ph::direct_control>(ph::tendon_two_link<float>(), in); break;
    case 3: cycle<ph::direct_control>(ph::five_bar<double, 4>(), in); break;
    default: {
      any_jacobian device;
      for (auto& entry : device.J.reshaped()) {
        const double x = in.number();
        entry = std::abs(x) < 1e-100 ? 0 : (std::abs(x) > 1e100 ? 1 : x);
      }
      cycle<ph::direct_control>(device, in);
    }
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

// Every other time puts a number of interest where a number may begin; else mutates bytes as usual.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
  using limits = std::numeric_limits<double>;
  constexpr double numbers[] = {0.0,
                                1.0,
                                limits::denorm_min(),
                                limits::min(),
                                limits::epsilon(),
                                limits::max(),
                                1e-300,
                                1e300,
                                limits::infinity(),
                                limits::quiet_NaN(),
                                0.02,
                                1e-9,
                                1e-3,
                                1e7,
                                0.5,
                                3.141592653589793};
  constexpr std::size_t count = sizeof numbers / sizeof *numbers, header = 2;
  if (seed % 2 == 0 || most < 256) return LLVMFuzzerMutate(data, size, most);
  for (; size < 256; ++size) data[size] = 0;
  const std::size_t at = header + (seed / 2 % ((size - header) / sizeof(double))) * sizeof(double);
  const unsigned pick = seed / 1024;
  double x = numbers[pick % count];
  if (pick / count % 4 == 0) std::memcpy(&x, data + at, sizeof x);  // its own neighbour
  if (pick / count % 8 < 2) x = std::nextafter(x, pick % 3 == 0 ? -limits::max() : limits::max());
  if (pick / count % 16 < 8) x = -x;
  std::memcpy(data + at, &x, sizeof x);
  return size;
}
