// A controller behind runtime/ beside the controller itself.
#pragma once

#include <passive_haptics/runtime/catalogue.hpp>
#include <passive_haptics/scene/scene.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <vector>

namespace ph = passive_haptics;
namespace rt = ph::runtime;

template <class V>
std::span<const double> numbers(const V& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}

template <class M>
rt::state_view view_of(const ph::device_state<M>& s) {
  return {s.time, numbers(s.q), numbers(s.qd), numbers(s.hand_force)};
}

// One motion, in poses that the mechanism has.
template <class M>
std::vector<ph::device_state<M>> random_motion(const M& mechanism, std::size_t cycles) {
  ph::testing::random_source random(20040627);
  std::vector<ph::device_state<M>> all;
  while (all.size() < cycles) {
    ph::device_state<M> s;
    s.time = 1e-3 * static_cast<double>(all.size());
    s.q = 1.2 * random.direction<double, M::dof>();
    s.qd = random.direction<double, M::dof>();
    s.hand_force = 2 * random.direction<double, M::task_dimension>();
    if (ph::all_finite(mechanism.position(s.q))) all.push_back(s);
  }
  return all;
}

inline bool operator==(const ph::contact_report<double>& a, const ph::contact_report<double>& b) {
  return a.wall_number == b.wall_number && a.wanted == b.wanted && a.displayed == b.displayed &&
         a.has_priority == b.has_priority;
}

// The same to the bit. A scene of one wall has no reports.
inline bool same(const rt::cycle_record& a, const rt::cycle_record& b) {
  return a.capacity == b.capacity && a.torque == b.torque && a.outcome == b.outcome && a.power == b.power &&
         a.display == b.display && a.saturated == b.saturated && a.wall_number == b.wall_number &&
         a.alpha == b.alpha && a.approximation_cosine == b.approximation_cosine &&
         a.desired_force == b.desired_force && a.control_force == b.control_force &&
         a.cone_coefficients == b.cone_coefficients && a.signs == b.signs &&
         a.settled_signs == b.settled_signs && a.settled_velocity == b.settled_velocity;
}

// Behind the plane through the first pose half of the others lie.
template <class M>
auto scene_through(const M& mechanism, const ph::joint_vector<M>& q) {
  using point = ph::point<M::task_dimension>;
  return ph::scene(ph::wall(ph::half_space<M::task_dimension>(mechanism.position(q), point::UnitY()), 1e3));
}

// Under law L at a plane: this mechanism with its own controller, and `entry` in a catalogue.
template <class L, class M>
void expect_same_cycles(const rt::catalogue& all, const rt::any_mechanism& mechanism, const char* law,
                        const M& own, std::size_t cycles) {
  const auto motion = random_motion(own, cycles);
  const auto scene = scene_through(own, motion[0].q);
  const rt::law_entry& entry = *rt::find(all.laws(), law);
  ASSERT_TRUE(all.is_compiled(mechanism, entry));
  ph::controller direct(own, rt::controller_brakes<M>(ph::brakes_of<M>()), scene, L());
  const auto any = all.make_controller(
      mechanism, entry,
      {rt::brake_numbers(M::brake_count), rt::any_scene<M::task_dimension>(scene), entry.defaults});
  std::size_t touched = 0;
  for (const auto& state : motion) {
    const rt::cycle_record expected(direct(state));
    touched += expected.wall_number == 0;
    ASSERT_TRUE(same((*any)(view_of(state)), expected)) << "cycle " << &state - motion.data();
  }
  EXPECT_GT(touched, cycles / 10);
}
