#include "prelude.hpp"

#ifdef without_scalar
// error: passive_haptics: the mechanism needs `using scalar = double;`
struct arm {
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  V2 position(const V2& q) const { return q; }
};
ph::device_state<arm> state;
#endif

#ifdef without_dof
// error: passive_haptics: the mechanism needs `static constexpr int dof`
struct arm {
  using scalar = double;
  static constexpr int task_dimension = 2, brake_count = 2;
  V2 position(const V2& q) const { return q; }
};
void cycle() { run(arm(), ph::unlimited_brakes(), room, ph::no_direct_control(), ph::device_state<table>()); }
#endif

#ifdef pose_as_task
// error: passive_haptics: task_dimension must be 1, 2 or 3: position(q) is a point, each component a length
struct arm {
  using scalar = double;
  static constexpr int dof = 6, task_dimension = 6, brake_count = 6;
  ph::vector<double, 6> position(const ph::vector<double, 6>& q) const { return q; }
};
ph::device_state<arm> state;
#endif

#ifdef more_brakes_without_a_transmission
// error: passive_haptics: unsupported sizes; needed are brake_count == dof >= task_dimension or, with a
// transmission, brake_count > dof == task_dimension
ph::step_result<slides<2, 3>> result;
#endif

#ifdef position_as_expression
// error: passive_haptics: position(q) must be const and return vector<scalar, task_dimension> exactly (not an
// Eigen expression)
struct arm {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  auto position(const V2& q) const { return 2 * q; }
};
ph::sensorless_device_state<arm> state;
#endif

#ifdef position_not_const
// error: passive_haptics: position(q) must be const
struct arm {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  template <class S>
  ph::vector<S, 2> position(const ph::vector<S, 2>& q) {
    return q;
  }
};
ph::device_state<arm> state;
#endif

#ifdef position_without_a_template
// error: passive_haptics: the mechanism needs jacobian(q), or position(q) templated on the scalar
struct arm {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  V2 position(const V2& q) const { return q; }
};
const auto J = ph::jacobian(arm(), V2(0, 0));
#endif

#ifdef position_with_std_functions
// error: passive_haptics: this drops the derivatives of position(q): write `using std::cos
struct arm : device {
  template <class S>
  ph::vector<S, 2> position(const ph::vector<S, 2>& q) const {
    return {std::cos(q[0]), std::sin(q[1])};
  }
};
const auto J = ph::jacobian(arm(), {0.3, 1});
#endif

#ifdef position_in_plain_numbers
// error: to 'const double'
struct arm : device {
  template <class S>
  ph::vector<S, 2> position(const ph::vector<S, 2>& q) const {
    const double angle = q[0];
    return {q[1], S(angle)};
  }
};
const auto J = ph::jacobian(arm(), {0.3, 1});
#endif

#ifdef jacobian_of_wrong_shape
// error: passive_haptics: jacobian must be const, take q or nothing, and return matrix<scalar,
// task_dimension, dof> exactly
struct arm : device {
  ph::matrix<double, 2, 3> jacobian(const V2&) const { return {}; }
};
void cycle() { run(arm(), ph::brakes_of<arm>(), room, ph::no_direct_control()); }
#endif

#ifdef transmission_of_wrong_shape
// error: passive_haptics: transmission must be const, take q or nothing, and return matrix<scalar,
// brake_count, dof> exactly
struct arm : ph::two_link<double> {
  ph::matrix<double, 2, 3> transmission() const { return {}; }
};
const auto J = ph::jacobian(arm(), V2(0, 0));
#endif

#ifdef pose_without_position
// error: passive_haptics: a mechanism with a pose(q) needs position(pose) and jacobian(pose)
struct arm : ph::two_link<double> {
  struct angles {};
  angles pose(const V2&) const { return {}; }
};
const auto J = ph::jacobian(arm(), V2(0, 0));
#endif

#ifdef brake_on_a_joint_that_is_not_there
// error: passive_haptics: braked_joints<M, i, j, ...> needs at least one number of a brake
const ph::braked_joints<slides<3>, 0, 3> two((slides<3>()));
#endif

#ifdef optional_member_misspelt
// error: constant
static_assert(ph::describe<table>().has("transmision"));
#endif

#ifdef parameter_misspelt
// error: lenght_1
ph::two_link<double> arm(ph::two_link_parameters<double>{.lenght_1 = 0.2});
#endif

#ifdef copy_of_a_part_of_a_device
// error: deleted
const ph::tendon_two_link<double> whole;
const ph::two_link<double> part = whole;
#endif
