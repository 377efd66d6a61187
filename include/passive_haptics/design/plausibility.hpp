/// @file
/// What looks odd about a device and its walls.
#pragma once

#include <passive_haptics/core/parameter_text.hpp>
#include <passive_haptics/mechanism/mechanism.hpp>
#include <passive_haptics/scene/scene.hpp>

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <type_traits>

namespace passive_haptics {
namespace detail {

// Remarks on each part that has parameters, the part named before.
template <class X>
std::string remarks_on(const std::string& part, const X& x) {
  std::string all;
  const auto add = [&](const auto& parameters) {
    std::istringstream lines(remarks(parameters));
    for (std::string line; std::getline(lines, line);)
      all.append(part).append(": ").append(line).append("\n");
  };
  if constexpr (Parameters<X>) add(x);
  else if constexpr (requires { requires Parameters<std::remove_cvref_t<decltype(x.parameters())>>; })
    add(x.parameters());
  return all;
}

}  // namespace detail

/// A line for each value that is allowed, but not usual for a device on a desk: "mechanism: length_1 [m] =
/// 150, usually 0.01 to 2", a wall of 1 N/m. Empty if there is none.
///
/// Of the mechanism, the brakes and the walls of a static_scene, as far as they have parameters with a table
/// (core/parameters.hpp); the ranges are the tables'. For a program to print as it starts, not for the loop.
template <class M, class B, class Scene>
std::string plausibility(const M& mechanism, const B& brakes, const Scene& scene) {
  std::string all = detail::remarks_on("mechanism", mechanism) + detail::remarks_on("brakes", brakes);
  if constexpr (requires { scene.for_each([](int, const auto&) {}); })
    scene.for_each([&](int number, const auto& w) {
      const std::string part = "wall " + std::to_string(number);
      all += detail::remarks_on(part, w) + detail::remarks_on(part, w.shape);
    });
  return all;
}

/// The same, and whether joint positions q look like degrees and the end effector there like millimetres.
/// Knows nothing but the mechanism's position, so it also is for one without a table.
template <class M, class B, class Scene>
std::string plausibility(const M& mechanism, const B& brakes, const Scene& scene, const joint_vector<M>& q) {
  constexpr double two_turns = 4 * std::numbers::pi, far = 5;  // [rad], [m]
  std::string all = plausibility(mechanism, brakes, scene);
  for (int i = 0; i < M::dof; ++i)
    if (std::abs(q[i]) > two_turns)
      all += "q[" + std::to_string(i) + "] [rad or m] = " + detail::number_text(q[i]) +
             ", more than two turns: degrees?\n";
  if (const auto reach = as<double>(mechanism.position(q)).norm(); reach > far)
    all += "mechanism: end effector " + detail::number_text(reach) + " m from the base: millimetres?\n";
  return all;
}

}  // namespace passive_haptics
