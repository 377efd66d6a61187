/// The paper's device: two links with both brakes at the base, coupled by tendons (Fig. 7).
#pragma once

#include <passive_haptics/core/linear/lane_products.hpp>
#include <passive_haptics/mechanism/models/two_link.hpp>

namespace passive_haptics {

/// two_link_parameters and the reduction of the tendon that drives link 2.
template <class T>
struct tendon_two_link_parameters {
  T length_1 = two_link_parameters<T>().length_1;                ///< l1 [m], section 5.1.
  T length_2 = two_link_parameters<T>().length_2;                ///< l2 [m], section 5.1.
  T mass_1 = two_link_parameters<T>().mass_1;                    ///< Link 1 [kg].
  T mass_2 = two_link_parameters<T>().mass_2;                    ///< Link 2 [kg].
  T handle_mass = two_link_parameters<T>().handle_mass;          ///< Point mass at the end effector [kg].
  T rotor_inertia_1 = two_link_parameters<T>().rotor_inertia_1;  ///< On the axis of brake 1 [kg m^2].
  T rotor_inertia_2 = two_link_parameters<T>().rotor_inertia_2;  ///< On the axis of brake 2 [kg m^2].
  T reduction_2 = T(0.4);                                        ///< k2 [1], section 5.1.

  /// Parameters of the links.
  constexpr two_link_parameters<T> arm() const {
    return {length_1, length_2, mass_1, mass_2, handle_mass, rotor_inertia_1, rotor_inertia_2};
  }

  static constexpr auto members() {
    using p = tendon_two_link_parameters;
    return member_table(member("length_1", &p::length_1, "m", range::positive),
                        member("length_2", &p::length_2, "m", range::positive),
                        member("mass_1", &p::mass_1, "kg", range::positive),
                        member("mass_2", &p::mass_2, "kg", range::positive),
                        member("handle_mass", &p::handle_mass, "kg", range::not_negative),
                        member("rotor_inertia_1", &p::rotor_inertia_1, "kg m^2", range::not_negative),
                        member("rotor_inertia_2", &p::rotor_inertia_2, "kg m^2", range::not_negative),
                        member("reduction_2", &p::reduction_2, "1", range::positive)
                            .suspicious_below(1e-3)
                            .suspicious_above(1000));
  }
};

/// two_link with brake 1 on joint 1, and brake 2 at the base with a tendon to link 2:
///
///     w = T qd,   T = [ 1    0    ]
///                     [ 1  1 / k2 ].
///
/// The paper gives k2 but not the coupling. This one reproduces its approximation angles on the wall y =
/// 0.225 m (about 3 deg at x = 0.06 m and 33 deg at x = 0.17 m, section 5.2).
template <class T>
class tendon_two_link : public two_link<T> {
 public:
  /// Throws std::invalid_argument if validate(p) returns an error.
  explicit tendon_two_link(const tendon_two_link_parameters<T>& p = {})
      : two_link<T>(require_valid(p).arm()), per_joint_2_(T(1) / p.reduction_2) {}

  /// T, constant.
  matrix<T, 2, 2> transmission() const { return matrix_of<2, 2>(T(1), T(0), T(1), per_joint_2_); }

  /// M [kg m^2] with the rotors on the brake axes: links + T^T diag(I_B) T.
  matrix<T, 2, 2> mass_matrix(const two_link_pose<T>& at) const {
    const auto& p = this->parameters();
    const matrix<T, 2, 2> t = transmission();
    const vector<T, 2> rotors(p.rotor_inertia_1, p.rotor_inertia_2);
    return this->link_mass_matrix(at) + transposed_times(t, scaled_rows(rotors, t));
  }
  matrix<T, 2, 2> mass_matrix(const vector<T, 2>& q) const { return mass_matrix(this->pose(q)); }  ///< M(q)

 private:
  T per_joint_2_;  // 1 / k2
};

}  // namespace passive_haptics
