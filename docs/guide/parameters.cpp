#include <passive_haptics/core/parameter_text.hpp>

#include <iostream>

namespace ph = passive_haptics;

struct spring_parameters {
  double stiffness = 100;  ///< [N/m]
  double rest_length = 0;  ///< [m]

  static constexpr auto members() {
    using p = spring_parameters;
    using ph::member, ph::range;
    return ph::member_table(member("stiffness", &p::stiffness, "N/m", range::positive),
                            member("rest_length", &p::rest_length, "m", range::not_negative));
  }
};

int main() {
  std::cout << ph::to_text(spring_parameters());  // stiffness [N/m] = 100 ...
  std::cout << ph::remarks(
      spring_parameters{.rest_length = 70});  // ... = 70, usually within 5 m: millimetres?
  std::cout << ph::validate(spring_parameters{.stiffness = -1});  // ... = -1: expected a finite number > 0
  std::cout << "\n";
}
