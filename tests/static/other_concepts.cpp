// Matrices, shapes, laws and states: what fits, and what only looks like it.
#include <passive_haptics/passive_haptics.hpp>

#include <limits>
#include <numbers>
#include <type_traits>
#include <utility>
#include <vector>

namespace ph = passive_haptics;

namespace {

using V2 = ph::vector<double, 2>;
using M23 = ph::matrix<double, 2, 3>;

// ---- exact matrices

static_assert(ph::ExactMatrix<M23, double, 2, 3> && ph::ExactMatrix<const M23&, double, 2, 3>);
static_assert(ph::ExactVector<V2, double, 2> && ph::ExactVector<ph::vector<float, 7>&&, float, 7>);
static_assert(!ph::ExactMatrix<M23, double, 3, 2> && !ph::ExactMatrix<M23, float, 2, 3>);
static_assert(!ph::ExactMatrix<Eigen::MatrixXd, double, 2, 3> && !ph::ExactMatrix<double, double, 1, 1>);
static_assert(!ph::ExactVector<Eigen::RowVector2d, double, 2> &&
              !ph::ExactVector<Eigen::VectorXd, double, 2>);
static_assert(!ph::ExactVector<decltype(V2() + V2()), double, 2>, "an expression");
static_assert(!ph::ExactVector<Eigen::Map<V2>, double, 2> && !ph::ExactVector<Eigen::Ref<V2>, double, 2>);
static_assert(!ph::ExactVector<Eigen::Array2d, double, 2>);
static_assert(!ph::ExactVector<Eigen::Matrix<double, 2, 1, Eigen::DontAlign>, double, 2>);
static_assert(!ph::ExactMatrix<Eigen::Matrix<double, 2, 3, Eigen::RowMajor>, double, 2, 3>);
static_assert(ph::ExactDiagonal<ph::diagonal_matrix<float, 3>, float, 3>);
static_assert(!ph::ExactDiagonal<ph::diagonal_matrix<float, 3>, double, 3> &&
              !ph::ExactDiagonal<ph::diagonal_matrix<float, 3>, float, 2>);
static_assert(!ph::ExactDiagonal<Eigen::Matrix3f, float, 3>);

// ---- shapes

static_assert(ph::Shape<ph::half_space<2>> && ph::Shape<ph::half_space<3>> && ph::Shape<ph::disc> &&
              ph::Shape<ph::ball<3>>);

static_assert(ph::Shape<ph::convex_polygon<3>> && ph::Shape<ph::convex_polytope<2, 1>>, "the fewest faces");
static_assert(ph::detail::is_wall<ph::wall<ph::disc>> && !ph::detail::is_wall<ph::disc>);

struct complete_shape {
  static constexpr int dimension = 2;
  double distance(const V2&) const;
  V2 gradient(const V2&) const;
};
static_assert(ph::Shape<complete_shape>);
struct shape_on_a_line {
  static constexpr int dimension = 1;
  double distance(const ph::point<1>&) const;
  ph::point<1> gradient(const ph::point<1>&) const;
};
static_assert(ph::Shape<shape_on_a_line>);
struct shape_without_dimension {
  double distance(const V2&) const;
  V2 gradient(const V2&) const;
};
struct shape_without_distance {
  static constexpr int dimension = 2;
  V2 gradient(const V2&) const;
};
struct shape_without_gradient {
  static constexpr int dimension = 2;
  double distance(const V2&) const;
};
struct distance_in_float : complete_shape {
  float distance(const V2&) const;
};
struct distance_not_const : complete_shape {
  double distance(const V2&);
};
struct gradient_in_float : complete_shape {
  ph::vector<float, 2> gradient(const V2&) const;
};
struct gradient_of_wrong_size : complete_shape {
  ph::vector<double, 3> gradient(const V2&) const;
};
struct shape_of_no_dimension : complete_shape {
  static constexpr int dimension = 0;
};
static_assert(!ph::Shape<shape_without_dimension> && !ph::Shape<shape_without_distance> &&
              !ph::Shape<shape_without_gradient>);
static_assert(!ph::Shape<distance_in_float> && !ph::Shape<distance_not_const> &&
              !ph::Shape<gradient_in_float>);
static_assert(!ph::Shape<gradient_of_wrong_size> && !ph::Shape<shape_of_no_dimension>);
static_assert(!ph::Shape<int> && !ph::Shape<ph::static_scene<ph::disc>>);

template <class Tracker>
struct followed_shape {
  static constexpr int dimension = 2;
  using tracker = Tracker;
  ph::bounding_box<2> bounds() const;
  template <class Add>
  double follow(const V2&, const V2&, tracker&, Add&&) const;
};
struct tracker_with_a_list {
  std::vector<int> list;
};
struct tracker_without_a_beginning {
  explicit tracker_without_a_beginning(int);
};
struct followed_without_a_tracker {
  static constexpr int dimension = 2;
  ph::bounding_box<2> bounds() const;
  template <class Add>
  double follow(const V2&, const V2&, int&, Add&&) const;
};
struct followed_without_bounds {
  static constexpr int dimension = 2;
  using tracker = int;
  template <class Add>
  double follow(const V2&, const V2&, tracker&, Add&&) const;
};
static_assert(ph::TrackedShape<followed_shape<int>>);
static_assert(!ph::TrackedShape<followed_shape<tracker_with_a_list>> &&
              !ph::TrackedShape<followed_shape<tracker_without_a_beginning>>);
static_assert(!ph::TrackedShape<followed_without_a_tracker> && !ph::TrackedShape<followed_without_bounds>);
static_assert(!ph::TrackedShape<complete_shape> && !ph::TrackedShape<int>);

// ---- control laws

static_assert(ph::ControlLaw<ph::no_direct_control> && ph::ControlLaw<ph::direct_control>);
static_assert(!ph::needs_hand_force<ph::no_direct_control> && ph::needs_hand_force<ph::direct_control>);
static_assert(ph::TorqueLaw<ph::velocity_direct_control> && !ph::ScalingLaw<ph::velocity_direct_control>);
static_assert(ph::ScalingLaw<ph::direct_control> && !ph::TorqueLaw<ph::direct_control>);
static_assert(ph::TorqueLaw<ph::on_off_control> && !ph::needs_hand_force<ph::on_off_control>);

struct complete_law {
  template <class T, int D>
  T scale(const ph::contact_situation<T, D>&) const noexcept;
};
static_assert(ph::ControlLaw<complete_law> && !ph::nulls_normal_force<complete_law>);
static_assert(!ph::needs_hand_force<complete_law> && !ph::needs_brake_lag<complete_law>);
struct law_in_float {
  template <class T, int D>
  float scale(const ph::contact_situation<T, D>&) const noexcept;
};
struct law_not_const {
  template <class T, int D>
  T scale(const ph::contact_situation<T, D>&) noexcept;
};
struct law_with_memory_to_be_filled {
  static constexpr bool commands_torques = true;
  struct memory {
    explicit memory(int);
  };
};
static_assert(!ph::ControlLaw<law_in_float> && !ph::ControlLaw<law_not_const>);
static_assert(!ph::ControlLaw<law_with_memory_to_be_filled> && !ph::ControlLaw<int>);

// ---- what a step needs, where all is included

struct redundant_device {  // as a user's, in no namespace of the library
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 3;
  V2 position(const V2& q) const { return q; }
  ph::matrix<double, 2, 2> jacobian(const V2&) const;
  ph::matrix<double, 3, 2> transmission() const;
};
template <class L>
inline constexpr bool is_law_for_redundant_brakes =
    ph::detail::is_law_for<redundant_device, L, ph::brakes_of<redundant_device>>();
static_assert(is_law_for_redundant_brakes<ph::direct_control>);
static_assert(is_law_for_redundant_brakes<ph::on_off_control>);

// ---- device states

using arm = ph::two_link<double>;
static_assert(ph::DeviceState<ph::device_state<arm>, arm> && ph::HandForceState<ph::device_state<arm>, arm>);
static_assert(ph::DeviceState<ph::sensorless_device_state<arm>, arm>);
static_assert(!ph::HandForceState<ph::sensorless_device_state<arm>, arm>);
static_assert(!ph::DeviceState<ph::device_state<ph::two_link<float>>, arm> && !ph::DeviceState<int, arm>);
static_assert(!ph::DeviceState<ph::device_state<arm>, int>, "no mechanism");

struct complete_state {
  double time;
  V2 q, qd, hand_force;
};
static_assert(ph::HandForceState<complete_state, arm>);
struct state_without_time {
  V2 q, qd;
};
struct state_of_wrong_size {
  double time;
  ph::vector<double, 3> q, qd;
};
struct state_with_force_in_float : state_without_time {
  double time;
  ph::vector<float, 2> hand_force;
};
static_assert(!ph::DeviceState<state_without_time, arm> && !ph::DeviceState<state_of_wrong_size, arm>);
static_assert(ph::DeviceState<state_with_force_in_float, arm> &&
              !ph::HandForceState<state_with_force_in_float, arm>);

// ---- a step never throws, and costs no memory for laws without any

using free_space = ph::contacts<2, 1>;
template <class M, class L>
inline constexpr bool step_is_noexcept = noexcept(ph::step(
    std::declval<const M&>(), std::declval<const ph::brakes_of<M>&>(), std::declval<const free_space&>(),
    std::declval<const L&>(), std::declval<const ph::device_state<M>&>(), std::declval<ph::step_memory<L>&>(),
    std::declval<const ph::step_options<typename M::scalar>&>()));
static_assert(step_is_noexcept<arm, ph::direct_control> &&
              step_is_noexcept<ph::xy_table<float>, ph::no_direct_control>);
static_assert(sizeof(ph::step_memory<ph::direct_control>) == sizeof(ph::approximation_start));
static_assert(std::is_trivially_destructible_v<free_space> &&
              std::is_trivially_destructible_v<ph::step_result<arm>>);

// ---- small constexpr functions

static_assert(ph::sgn(2.5) == 1 && ph::sgn(-0.1f) == -1 && ph::sgn(0.0) == 0 && ph::sgn(-0.0) == 0);
static_assert(ph::sgn(std::numeric_limits<double>::quiet_NaN()) == 0);
static_assert(ph::degrees(ph::radians(90.0)) == 90 && ph::radians(180.0) == std::numbers::pi);
static_assert(ph::rounding_tolerance<float>(2) == 8 * std::numeric_limits<float>::epsilon());

}  // namespace
