/// Plausibility of a device and its walls.
#pragma once

#include <passive_haptics/core/parameter_text.hpp>
#include <passive_haptics/mechanism/mechanism.hpp>
#include <passive_haptics/scene/scene.hpp>

#include <string>
#include <type_traits>

namespace passive_haptics {
namespace detail {

template <class X>
std::string remarks_on(const std::string& part, const X& x) {
  if constexpr (Parameters<X>) return remarks(x, part + ": ");
  else if constexpr (requires { requires Parameters<std::remove_cvref_t<decltype(x.parameters())>>; })
    return remarks(x.parameters(), part + ": ");
  else return "";
}

}  // namespace detail

/// Returns a line for each value of mechanism, brakes and walls that is allowed, but looks like another unit:
/// "mechanism: length_1 [m] = 150, usually within 5 m: millimetres?"; see usual_range(). For set-up.
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

/// Also checks whether q looks like degrees, the end effector like millimetres or deep inside a wall. Uses
/// only the mechanism's position, so the mechanism needs no table.
template <class M, class B, class Scene>
std::string plausibility(const M& mechanism, const B& brakes, const Scene& scene, const joint_vector<M>& q) {
  std::string all = plausibility(mechanism, brakes, scene);
  for (int i = 0; i < M::dof; ++i)
    all += detail::remark_on("q[" + std::to_string(i) + "] [rad or m]", "rad", q[i]);
  const double reach = as<double>(mechanism.position(q)).norm();
  all += detail::remark_on("mechanism: distance of the end effector from the base [m]", "m", reach);
  if constexpr (requires { scene.for_each([](int, const auto&) {}); })
    scene.for_each([&](int number, const auto& w) {
      const double distance = w.shape.distance(as<double>(mechanism.position(q)));
      const std::string part = "wall " + std::to_string(number) + ": distance of the end effector [m]";
      constexpr double deep = 0.01;  // [m]
      all += distance < -deep ? part + " = " + detail::value_text(distance) +
                                    ", usually outside at the start: a normal that points into the wall?\n"
                              : detail::remark_on(part, "m", distance);
    });
  return all;
}

}  // namespace passive_haptics
