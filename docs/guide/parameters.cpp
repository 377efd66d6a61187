#include <passive_haptics/core/parameter_text.hpp>

#include <iostream>

namespace ph = passive_haptics;

struct spring_parameters {
  double stiffness = 100;  ///< [N/m]
  double rest_length = 0;  ///< [m]

  static constexpr auto members() {
    using p = spring_parameters;
    using ph::member, ph::range, ph::plausible;
    return ph::member_table(
        member("stiffness", &p::stiffness, "N/m", range::positive, plausible(1, 1e4)),
        member("rest_length", &p::rest_length, "m", range::not_negative, plausible(0, 1)));
  }
};

int main() {
  std::cout << ph::to_text(spring_parameters());                  // stiffness [N/m] = 100 ...
  std::cout << ph::remarks(spring_parameters{.stiffness = 5e4});  // ... = 50000, usually 1 to 10000
  std::cout << ph::validate(spring_parameters{.stiffness = -1});  // ... = -1, expected a finite number > 0
  std::cout << "\n";
}
