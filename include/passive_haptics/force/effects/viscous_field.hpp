/// A viscous field, F = -B v.
#pragma once

#include <passive_haptics/core/linear/cholesky.hpp>
#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/force/effect.hpp>

namespace passive_haptics {

/// Parameters of a viscous field.
template <class T, int D>
struct viscous_field_parameters {
  matrix<T, D, D> viscosity = matrix<T, D, D>::Zero();  ///< B [N s/m], base frame; v . B v >= 0 for all v.

  static constexpr const char* type_name = "a viscous_field";  ///< For errors.
  static constexpr auto members() {
    using p = viscous_field_parameters;
    return member_table(member("viscosity", &p::viscosity, "N s/m", range::finite));
  }
  /// The field must not drive. Eigenvalues down to -rounding |B| count as zero.
  error_message rules() const {
    const T size = viscosity.norm();
    const matrix<T, D, D> rounding = rounding_tolerance<T>(D) * size * matrix<T, D, D>::Identity();
    const matrix<T, D, D> symmetric = (viscosity + viscosity.transpose()) / T(2) + rounding;
    if (!(size > T(0)) || cholesky<T, D>(symmetric).is_positive_definite()) return {};
    return "viscosity of a viscous_field would drive some motion: expected v . B v >= 0 for all v";
  }
};

/// F = -B v everywhere. B may be anisotropic and may have a part that deflects the force without power (B !=
/// B^T), which brakes display as far as their cone permits. Source: R. Shadmehr, F. A. Mussa-Ivaldi, Adaptive
/// representation of dynamics during learning of a motor task, J. Neuroscience 14(5), 1994, pp. 3208-3224.
template <class T, int D>
class viscous_field {
 public:
  using scalar = T;                    ///< Scalar type.
  static constexpr int dimension = D;  ///< Task dimension d.

  /// Throws std::invalid_argument if validate(p) returns an error.
  explicit viscous_field(const viscous_field_parameters<T, D>& p) : viscosity_(require_valid(p).viscosity) {}

  /// Returns -B v [N] for the velocity v [m/s]; ignores the other arguments.
  vector<T, D> force(const vector<T, D>&, const vector<T, D>& v,
                     const vector<T, D>& = vector<T, D>::Zero()) const {
    return -viscosity_ * v;
  }

 private:
  matrix<T, D, D> viscosity_;
};

}  // namespace passive_haptics
