/// @file
/// Geometry and inertia of a five-bar.
#pragma once

#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/core/validate.hpp>

#include <algorithm>

namespace passive_haptics {

/// Two poses of the handle close the loop; a five-bar keeps to one.
enum class five_bar_assembly {
  left,   ///< The handle lies left of the line from elbow 1 to elbow 2: ahead of the base, by default.
  right,  ///< It lies right of it.
};

/// Lengths of the Pantograph Mk-II (Campion, Wang, Hayward 2005). Uniform rods with a point mass at the
/// handle, masses those of a light desktop device.
template <class T, int Brakes = 2>
struct five_bar_parameters {
  T base_distance = T(0.025);                            ///< Between the base joints [m], >= 0.
  T proximal_1 = T(0.063);                               ///< From base joint 1 to elbow 1 [m].
  T proximal_2 = T(0.063);                               ///< From base joint 2 to elbow 2 [m].
  T distal_1 = T(0.075);                                 ///< From elbow 1 to the handle [m].
  T distal_2 = T(0.075);                                 ///< From elbow 2 to the handle [m].
  five_bar_assembly assembly = five_bar_assembly::left;  ///< Side of the handle.
  T proximal_mass = T(0.05);                             ///< Of each [kg].
  T distal_mass = T(0.05);                               ///< Of each [kg].
  T handle_mass = T(0.1);                                ///< Point mass at the handle [kg].
  vector<T, Brakes> rotor_inertia = vector<T, Brakes>::Constant(T(5e-5));  ///< On the brakes' axes [kg m^2].
  vector<T, 2> gravity = vector<T, 2>::Zero();  ///< [m/s^2]; zero: the plane is horizontal.
};

/// What is wrong with the parameters; empty if nothing.
template <class T, int Brakes>
std::string validate(const five_bar_parameters<T, Brakes>& p) {
  using namespace detail;
  const std::string lengths = first_error(
      check_not_negative("base_distance [m]", p.base_distance),
      check_positive("proximal_1 [m]", p.proximal_1), check_positive("proximal_2 [m]", p.proximal_2),
      check_positive("distal_1 [m]", p.distal_1), check_positive("distal_2 [m]", p.distal_2));
  std::string rotors;
  for (int i = 0; i < Brakes && rotors.empty(); ++i)
    rotors = check_not_negative(detail::indexed("rotor_inertia[", i, "] [kg m^2]"), p.rotor_inertia[i]);
  const T perimeter = p.base_distance + p.proximal_1 + p.proximal_2 + p.distal_1 + p.distal_2;
  const T longest = std::max({p.base_distance, p.proximal_1, p.proximal_2, p.distal_1, p.distal_2});
  const std::string loop = longest < perimeter - longest
                               ? ""
                               : error_text("longest length [m]", longest, "less than all others together");
  return first_error(lengths, loop, check_positive("proximal_mass [kg]", p.proximal_mass),
                     check_not_negative("distal_mass [kg]", p.distal_mass),
                     check_not_negative("handle_mass [kg]", p.handle_mass), rotors,
                     check_finite("gravity[0] [m/s^2]", p.gravity[0]),
                     check_finite("gravity[1] [m/s^2]", p.gravity[1]));
}

}  // namespace passive_haptics
