// Serial chains of irregular shape for the property suites.
#pragma once

#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

namespace chains {

namespace ph = passive_haptics;

// Odd chains have a sliding joint in the middle, even ones gravity.
template <class T, int N, int D>
struct irregular_chain {
  using mechanism = ph::serial_chain_with_inertia<T, N, D>;
  static constexpr bool has_gravity = N % 2 == 0;

  static ph::serial_chain_parameters<T, N, D> geometry() {
    ph::testing::random_source random(100 + N);
    ph::serial_chain_parameters<T, N, D> p;
    ph::vector<T, D> end = random.normal_vector<T, D>() * T(0.05);
    for (int i = 0; i < N; ++i) {
      const bool slides = N % 2 == 1 && i == N / 2;
      p.joints[std::size_t(i)] = {slides ? ph::joint_kind::prismatic : ph::joint_kind::revolute,
                                  T(2) * random.direction<T, D>(), end};
      end += T(0.2) * random.direction<T, D>();
    }
    p.handle = end;
    return p;
  }

  static ph::serial_chain_inertia<T, N, D> inertia() {
    ph::testing::random_source random(200 + N);
    ph::serial_chain_inertia<T, N, D> p;
    for (auto& link : p.links) {
      link = ph::uniform_rod<T, D>(random.uniform(T(0.1), T(0.3)), T(0.2) * random.normal_vector<T, D>(),
                                   T(0.2) * random.normal_vector<T, D>());
      const auto other =
          ph::uniform_rod<T, D>(random.uniform(T(0.1), T(0.3)), T(0.2) * random.normal_vector<T, D>(),
                                T(0.2) * random.normal_vector<T, D>());
      link = ph::joined<T, D>(link, other);
    }
    for (int i = 0; i < N; ++i) p.rotor_inertia[i] = random.uniform(T(1e-4), T(1e-3));
    p.handle_mass = T(0.15);
    if (has_gravity) p.gravity = T(9.81) * random.direction<T, D>();
    return p;
  }

  static mechanism make() { return mechanism(geometry(), inertia()); }
  static ph::vector<T, N> lower() { return ph::vector<T, N>::Constant(T(-2)); }
  static ph::vector<T, N> upper() { return ph::vector<T, N>::Constant(T(2)); }
};

}  // namespace chains
