/// Geometry and inertia of a five-bar.
#pragma once

#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/core/parameters.hpp>

#include <algorithm>

namespace passive_haptics {

/// Assembly mode: two handle poses close the loop; a five-bar stays in one.
enum class five_bar_assembly {
  left,   ///< Left of the line from elbow 1 to elbow 2: by default ahead of the base.
  right,  ///< Right of it.
};

/// Parameters of a five-bar. Default lengths are those of the Pantograph Mk-II (Campion, Wang, Hayward 2005),
/// masses those of a light desktop device: uniform rods with a point mass at the handle.
template <class T, int Brakes = 2>
struct five_bar_parameters {
  T base_distance = T(0.025);                            ///< Between the base joints [m], >= 0.
  T proximal_1 = T(0.063);                               ///< From base joint 1 to elbow 1 [m].
  T proximal_2 = T(0.063);                               ///< From base joint 2 to elbow 2 [m].
  T distal_1 = T(0.075);                                 ///< From elbow 1 to the handle [m].
  T distal_2 = T(0.075);                                 ///< From elbow 2 to the handle [m].
  five_bar_assembly assembly = five_bar_assembly::left;  ///< Side of the handle.
  T proximal_mass = T(0.05);                             ///< Of each proximal link [kg].
  T distal_mass = T(0.05);                               ///< Of each distal link [kg].
  T handle_mass = T(0.1);                                ///< Point mass at the handle [kg].
  vector<T, Brakes> rotor_inertia = vector<T, Brakes>::Constant(T(5e-5));  ///< On the brake axes [kg m^2].
  vector<T, 2> gravity = vector<T, 2>::Zero();  ///< [m/s^2]; zero: the plane is horizontal.

  static constexpr auto members() {
    using p = five_bar_parameters;
    return member_table(member("base_distance", &p::base_distance, "m", range::not_negative),
                        member("proximal_1", &p::proximal_1, "m", range::positive),
                        member("proximal_2", &p::proximal_2, "m", range::positive),
                        member("distal_1", &p::distal_1, "m", range::positive),
                        member("distal_2", &p::distal_2, "m", range::positive),
                        choice("assembly", &p::assembly, "left, right"),
                        member("proximal_mass", &p::proximal_mass, "kg", range::positive),
                        member("distal_mass", &p::distal_mass, "kg", range::not_negative),
                        member("handle_mass", &p::handle_mass, "kg", range::not_negative),
                        member("rotor_inertia", &p::rotor_inertia, "kg m^2", range::not_negative),
                        member("gravity", &p::gravity, "m/s^2", range::finite));
  }
  /// The loop can be closed.
  error_message rules() const {
    const T perimeter = base_distance + proximal_1 + proximal_2 + distal_1 + distal_2;
    const T longest = std::max({base_distance, proximal_1, proximal_2, distal_1, distal_2});
    if (longest < perimeter - longest) return {};
    return detail::error_text("longest length [m]", longest, "less than all others together");
  }
};

}  // namespace passive_haptics
