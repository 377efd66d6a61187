// What is a mechanism, and what only looks like one.
#include "../property/custom_mechanisms.hpp"

#include <passive_haptics/brake/brake_jacobian.hpp>
#include <passive_haptics/brake/reference_forces.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>

#include <string>
#include <utility>

namespace ph = passive_haptics;

namespace near_misses {

using V2 = ph::vector<double, 2>;
using M2 = ph::matrix<double, 2, 2>;

// ---- what fits

template <template <class> class M>
inline constexpr bool device_fits =
    ph::Mechanism<M<float>> && ph::Mechanism<M<double>> && ph::Mechanism<M<long double>> &&
    ph::DifferentiableMechanism<M<double>> && ph::Dynamics<M<float>> && ph::Dynamics<M<double>>;
static_assert(device_fits<ph::two_link> && device_fits<ph::tendon_two_link> && device_fits<ph::xy_table>);

template <class M>
inline constexpr bool fits = ph::Mechanism<M> && ph::DifferentiableMechanism<M>;
static_assert(fits<custom::archetype> && fits<custom::planar_arm<float>> &&
              fits<custom::spatial_arm<double>>);
static_assert(fits<custom::geared_slides<float>> && fits<custom::skew_table<double>> &&
              fits<custom::coupled_arm<float>>);
static_assert(fits<custom::lever<double>> && ph::Dynamics<custom::lever<float>>);
static_assert(fits<const custom::planar_arm<double>>);

// ---- what would dangle

using arm = ph::two_link<double>;
static_assert(std::is_constructible_v<ph::mechanism_pose<arm>, const arm&, const V2&> &&
              !std::is_constructible_v<ph::mechanism_pose<arm>, const arm&, V2>);

// ---- what does not: near misses beside those of tests/compile_fail/mechanism.cpp, each derived from this
// complete one

struct complete {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  V2 position(const V2& q) const;
  M2 jacobian(const V2& q) const;
};
static_assert(fits<complete>);

struct integer_scalar : complete {
  using scalar = int;
};
struct without_task_dimension {
  using scalar = double;
  static constexpr int dof = 2, brake_count = 2;
  V2 position(const V2&) const;
};
struct without_brakes {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2;
  V2 position(const V2&) const;
};
struct without_joints : complete {
  static constexpr int dof = 0;
};
struct dof_known_at_run_time : complete {
  inline static int dof = 2;
};
struct too_few_joints : complete {
  static constexpr int task_dimension = 3;
  ph::vector<double, 3> position(const V2&) const;
  ph::matrix<double, 3, 2> jacobian(const V2&) const;
};
struct redundant_brakes : complete {
  static constexpr int brake_count = 4;
};
static_assert(!ph::Mechanism<integer_scalar> && !ph::Mechanism<without_task_dimension> &&
              !ph::Mechanism<without_brakes>);
static_assert(!ph::Mechanism<without_joints> && !ph::Mechanism<dof_known_at_run_time>);
static_assert(!ph::Mechanism<too_few_joints> && !ph::Mechanism<redundant_brakes>);

struct without_position {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
};
struct position_not_const : without_position {
  V2 position(const V2& q);
};
struct position_of_wrong_size : without_position {
  ph::vector<double, 3> position(const V2&) const;
};
struct position_in_float : without_position {
  ph::vector<float, 2> position(const V2&) const;
};
static_assert(!ph::Mechanism<without_position> && !ph::Mechanism<position_not_const> &&
              !ph::Mechanism<position_of_wrong_size>);
static_assert(!ph::Mechanism<position_in_float>);

struct only_a_position : without_position {
  V2 position(const V2& q) const;
};
static_assert(ph::Mechanism<only_a_position> && !ph::DifferentiableMechanism<only_a_position>);

// A member called jacobian that does not fit is a mistake, not a mechanism without one.
struct jacobian_transposed : custom::sizes<double, 3, 2> {
  V2 position(const ph::vector<double, 3>&) const;
  ph::matrix<double, 3, 2> jacobian(const ph::vector<double, 3>&) const;
};
struct jacobian_not_const : only_a_position {
  M2 jacobian(const V2&);
};
struct jacobian_diagonal_but_wide : custom::sizes<double, 3, 2> {
  V2 position(const ph::vector<double, 3>&) const;
  ph::diagonal_matrix<double, 3> jacobian() const;
};
static_assert(!ph::Mechanism<jacobian_transposed> && !ph::Mechanism<jacobian_not_const> &&
              !ph::Mechanism<jacobian_diagonal_but_wide>);

struct transmission_not_const : complete {
  M2 transmission();
};
static_assert(!ph::Mechanism<transmission_not_const>);

struct mass_matrix_of_wrong_shape : ph::two_link<double> {
  ph::matrix<double, 3, 3> mass_matrix(const V2&) const;
};
struct bias_torque_of_wrong_size : ph::two_link<double> {
  ph::vector<double, 3> bias_torque(const V2&, const V2&) const;
};
struct bias_acceleration_without_rates : ph::two_link<double> {
  V2 bias_acceleration(const V2&) const;
};
static_assert(!ph::Dynamics<complete> && !ph::Dynamics<mass_matrix_of_wrong_shape> &&
              !ph::Dynamics<bias_torque_of_wrong_size>);
static_assert(!ph::Dynamics<bias_acceleration_without_rates>);

static_assert(!ph::Mechanism<int> && !ph::Mechanism<void> && !ph::Mechanism<std::string> &&
              !ph::Mechanism<complete*>);
static_assert(!ph::Mechanism<complete&>, "a mechanism is a value");

// ---- the hints survive to E

template <class M>
using E_of = decltype(ph::brake_jacobian(std::declval<const M&>(), ph::joint_vector<M>()));
static_assert(ph::ExactDiagonal<E_of<ph::xy_table<float>>, float, 2>);
static_assert(ph::ExactDiagonal<E_of<custom::geared_slides<double>>, double, 2>);
static_assert(ph::ExactMatrix<E_of<ph::tendon_two_link<double>>, double, 2, 2>);
static_assert(ph::ExactMatrix<E_of<custom::skew_table<double>>, double, 2, 3>);
static_assert(ph::ExactMatrix<E_of<custom::coupled_arm<float>>, float, 2, 2>);

// Reference forces are the inverse of a square E.
template <class M>
concept has_reference_forces =
    requires(const M m, const ph::joint_vector<M> q) { ph::reference_forces(m, q); };
static_assert(has_reference_forces<ph::two_link<double>> && has_reference_forces<custom::spatial_arm<float>>);
static_assert(!has_reference_forces<custom::planar_arm<double>> &&
              !has_reference_forces<custom::skew_table<float>>);

}  // namespace near_misses
