/// @file
/// A viscous field, F = -B v.
#pragma once

#include <passive_haptics/core/linear/cholesky.hpp>
#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/force/effect.hpp>

namespace passive_haptics {

/// The viscosity of a field.
template <class T, int D>
struct viscous_field_parameters {
  matrix<T, D, D> viscosity = matrix<T, D, D>::Zero();  ///< B [N s/m], base frame; v . B v >= 0 for all v.

  static constexpr const char* type_name = "a viscous_field";  ///< In errors.
  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = viscous_field_parameters;
    return member_table(member("viscosity", &p::viscosity, "N s/m", range::finite));
  }
  /// It drives no motion. Eigenvalues down to -rounding |B| count as zero.
  error_message rules() const {
    const T size = viscosity.norm();
    const matrix<T, D, D> rounding = rounding_tolerance<T>(D) * size * matrix<T, D, D>::Identity();
    const matrix<T, D, D> symmetric = (viscosity + viscosity.transpose()) / T(2) + rounding;
    if (!(size > T(0)) || cholesky<T, D>(symmetric).is_positive_definite()) return {};
    return "viscosity of a viscous_field would drive some motion, expected v . B v >= 0 for all v";
  }
};

/// F = -B v everywhere. B may be anisotropic (easy along one direction) and have a part that turns the force
/// across the motion without power (B != B^T); brakes display that part as far as their cone allows.
///
/// Reference for such fields: R. Shadmehr, F. A. Mussa-Ivaldi, Adaptive representation of dynamics during
/// learning of a motor task, J. Neuroscience 14(5), 1994, pp. 3208-3224.
template <class T, int D>
class viscous_field {
 public:
  using scalar = T;                    ///< Scalar of forces.
  static constexpr int dimension = D;  ///< d

  /// Throws std::invalid_argument with the text of validate(p).
  explicit viscous_field(const viscous_field_parameters<T, D>& p) : viscosity_(require_valid(p).viscosity) {}

  /// -B v [N]; of its arguments only the velocity [m/s] matters.
  vector<T, D> force(const vector<T, D>&, const vector<T, D>& v,
                     const vector<T, D>& = vector<T, D>::Zero()) const {
    return -viscosity_ * v;
  }

 private:
  matrix<T, D, D> viscosity_;
};

}  // namespace passive_haptics
