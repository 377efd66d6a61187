// Closed chains, both assemblies, regular and lopsided, for the property suites.
#pragma once

#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>

#include <gtest/gtest.h>

namespace closed_chains {

namespace ph = passive_haptics;

template <class T>
struct pantograph {
  using mechanism = ph::five_bar<T>;
  static mechanism make() { return mechanism(); }
  static ph::vector<T, 2> lower() { return {T(1.7), T(0.2)}; }
  static ph::vector<T, 2> upper() { return {T(2.9), T(1.4)}; }
};

// The handle behind the elbows, no two links alike, in a vertical plane.
template <class T, int Brakes = 2>
struct lopsided_five_bar {
  using mechanism = ph::five_bar<T, Brakes>;
  static constexpr bool has_gravity = true;
  static ph::five_bar_parameters<T, Brakes> parameters() {
    ph::five_bar_parameters<T, Brakes> p;
    p.base_distance = T(0.04), p.proximal_1 = T(0.07), p.proximal_2 = T(0.09), p.distal_1 = T(0.15);
    p.distal_2 = T(0.12), p.assembly = ph::five_bar_assembly::right, p.gravity = {T(1), T(-9.81)};
    for (int i = 0; i < Brakes; ++i) p.rotor_inertia[i] = T(1e-5) * T(i + 1);
    return p;
  }
  static mechanism make() { return mechanism(parameters()); }
  static ph::vector<T, 2> lower() { return {T(1.9), T(0.1)}; }
  static ph::vector<T, 2> upper() { return {T(2.9), T(1.1)}; }
};

// Without gravity: what the brakes hold is the hand.
template <int Brakes>
struct level_five_bar : lopsided_five_bar<double, Brakes> {
  using mechanism = ph::five_bar<double, Brakes>;
  static constexpr bool has_gravity = false;
  static mechanism make() {
    auto p = level_five_bar::parameters();
    p.gravity.setZero();
    return mechanism(p);
  }
};

template <class T>
struct desktop_delta {
  using mechanism = ph::delta<T>;
  static mechanism make() { return mechanism(); }
  static ph::vector<T, 3> lower() { return ph::vector<T, 3>::Constant(T(-0.3)); }
  static ph::vector<T, 3> upper() { return ph::vector<T, 3>::Constant(T(1.1)); }
};

template <class T>
struct upside_down_delta {
  using mechanism = ph::delta<T>;
  static constexpr bool has_gravity = true;
  static mechanism make() {
    ph::delta_parameters<T> p;
    p.assembly = ph::delta_assembly::upper, p.platform_radius = T(0.06), p.forearm = T(0.1);
    p.rotor_inertia = {T(1e-5), T(2e-5), T(3e-5)}, p.gravity = {T(1), T(2), T(-9.81)};
    return mechanism(p);
  }
  static ph::vector<T, 3> lower() { return ph::vector<T, 3>::Constant(T(-0.9)); }
  static ph::vector<T, 3> upper() { return ph::vector<T, 3>::Constant(T(0.3)); }
};

}  // namespace closed_chains
