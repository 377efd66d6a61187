// The laws of the experiments. A new law of the library is one line in the table below; the tables of scenes
// use examples/catalogue/laws.hpp.
#pragma once

#include "rivals/bang_bang_control.hpp"
#include "rivals/coercive_force_approximation.hpp"
#include "rivals/single_degree_of_freedom_control.hpp"
#include "rivals/velocity_ratio_control.hpp"

#include <passive_haptics/passive_haptics.hpp>

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>

namespace experiments {

namespace ph = passive_haptics;

// Rows of the table.
enum class law {
  none,
  direct,            // as printed
  saturated,         // direct, with alpha applied after the torque limit
  direct_dead_band,  // nulls from n . v > -v_dead on
  coercive,
  single_degree_of_freedom,
  velocity_ratio,
  on_off,
  bang_bang,
  velocity_on_touch,  // walls seen at the touch
  velocity,           // walls seen before the touch
};

template <class Make>
struct compared_law {
  const char* name;
  const char* colour;  // colour-blind safe (Okabe and Ito 2008), in every picture
  Make make;
};
template <class Make>
compared_law(const char*, const char*, Make) -> compared_law<Make>;
inline constexpr std::tuple compared_laws{
    compared_law{"no_direct_control", "#d55e00", [] { return ph::no_direct_control(); }},
    compared_law{"direct_control", "#0072b2", [] { return ph::direct_control(); }},
    compared_law{"saturated_direct_control", "#cc79a7", [] { return ph::saturated_direct_control(); }},
    compared_law{"direct_control, dead band", "#56b4e9",
                 [] { return ph::direct_control{.velocity_dead_band = 0.025}; }},
    compared_law{"coercive_force_approximation", "#994f00", [] { return coercive_force_approximation(); }},
    compared_law{"single_degree_of_freedom_control", "#e69f00",
                 [] { return single_degree_of_freedom_control(); }},
    compared_law{"velocity_ratio_control", "#7f6000", [] { return velocity_ratio_control(); }},
    compared_law{"on_off_control", "#888888", [] { return ph::on_off_control(); }},
    compared_law{"bang_bang_control", "#aaaa00", [] { return bang_bang_control(); }},
    compared_law{"velocity_direct_control, on touch", "#000000",
                 [] { return ph::velocity_direct_control({.approach_speed = 0}); }},
    compared_law{"velocity_direct_control", "#009e73", [] { return ph::velocity_direct_control(); }},
};

inline constexpr auto all_laws = [] {
  std::array<law, std::tuple_size_v<decltype(compared_laws)>> all{};
  int row = 0;
  for (law& one : all) one = static_cast<law>(row++);
  return all;
}();
static_assert(all_laws.back() == law::velocity, "A row of compared_laws for each law.");

constexpr std::string_view name_of(law which) {
  return std::apply([&](const auto&... row) { return std::array{row.name...}; },
                    compared_laws)[static_cast<std::size_t>(which)];
}

// Calls f(name, law) for each of these.
template <law... Which, class F>
void for_laws(F&& f) {
  (f(std::string(name_of(Which)), std::get<static_cast<std::size_t>(Which)>(compared_laws).make()), ...);
}

// Calls f(law) for a law chosen at run time.
template <class F>
auto with_law(law which, F&& f) {
  std::optional<decltype(f(std::get<0>(compared_laws).make()))> made;
  int row = 0;
  const auto look = [&](const auto& one) {
    if (row++ == static_cast<int>(which)) made.emplace(f(one.make()));
  };
  std::apply([&](const auto&... one) { (look(one), ...); }, compared_laws);
  if (!made) throw std::logic_error("a law without a row");
  return *std::move(made);
}

}  // namespace experiments
