// A type that wraps another one keeps its optional members. A member that a concept gains is added to the
// complete types here (describe() counts those of a mechanism), so that no wrapper forgets it.
#include <passive_haptics/mechanism/models/closed_chain.hpp>
#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/brakes/any_brake.hpp>
#include <passive_haptics/plant/brakes/compensated_brake.hpp>
#include <passive_haptics/plant/brakes/coulomb_brake.hpp>
#include <passive_haptics/plant/brakes/delayed_brake.hpp>
#include <passive_haptics/plant/brakes/presliding_brake.hpp>
#include <passive_haptics/runtime/any_shape.hpp>
#include <passive_haptics/runtime/mechanism_of_kind.hpp>

#include <algorithm>

namespace ph = passive_haptics;

namespace {

// ---- mechanisms

// Every member that the library reads
template <int N>
struct complete_mechanism {
  using scalar = double;
  static constexpr int dof = N, task_dimension = 2, brake_count = N;
  using joints = ph::vector<double, N>;
  using square = ph::matrix<double, N, N>;
  struct pose_type {};
  pose_type pose(const joints&) const;
  ph::vector<double, 2> position(const joints&) const;
  ph::vector<double, 2> position(const pose_type&) const;
  ph::matrix<double, 2, N> jacobian(const joints&) const;
  ph::matrix<double, 2, N> jacobian(const pose_type&) const;
  square transmission(const joints&) const;
  ph::matrix<double, N, 2> inverse_jacobian(const joints&) const;
  ph::matrix<double, 2, N> inverse_transposed_jacobian(const joints&) const;
  ph::chain_conditioning<double> conditioning(const joints&) const;
  square mass_matrix(const joints&) const;
  joints bias_torque(const joints&, const joints&) const;
  ph::vector<double, 2> bias_acceleration(const joints&, const joints&) const;
  joints brake_bias_acceleration(const joints&, const joints&) const;
  const ph::two_link_parameters<double>& parameters() const { return all; }
  ph::two_link_parameters<double> all;
};

template <class M>
constexpr bool has_all_of_a_mechanism =
    std::ranges::all_of(ph::describe<M>().members, [](const auto& m) { return m.found; }) &&
    requires(const M m) { ph::remarks(m.parameters()); };

using three_joints = complete_mechanism<3>;
using two_joints = complete_mechanism<2>;
static_assert(has_all_of_a_mechanism<three_joints> && has_all_of_a_mechanism<two_joints>);
static_assert(has_all_of_a_mechanism<ph::braked_joints<three_joints, 0, 2>>);
static_assert(ph::ClosedChain<two_joints> && ph::ClosedChain<ph::braked_joints<two_joints, 0>>);

// The concepts look at these members by arguments that they do not take
static_assert(ph::detail::differentiates_transmission<ph::braked_joints<ph::five_bar<double, 4>, 0, 1>> ==
              ph::detail::differentiates_transmission<ph::five_bar<double, 4>>);
static_assert(!ph::detail::differentiates_transmission<ph::braked_joints<three_joints, 0>>);

using any_mechanism = ph::runtime::mechanism_of_kind<ph::runtime::mechanism_kind{2, 2, 2, false}>;
static_assert(ph::Dynamics<any_mechanism> && ph::detail::has_pose<any_mechanism>);

// ---- shapes

struct complete_shape {
  static constexpr int dimension = 2;
  static constexpr bool has_unit_gradient = true;
  double distance(const ph::point<2>&) const;
  ph::point<2> gradient(const ph::point<2>&) const;
  ph::matrix<double, 2, 2> hessian(const ph::point<2>&) const;
  ph::point<2> velocity(const ph::point<2>&) const;
  ph::bounding_box<2> bounds() const;
  void extrapolate(double);
};

// But the bounds, which a complement does not have and a moving shape changes
template <class S>
constexpr bool has_all_of_a_shape = ph::gradient_is_unit<S> && ph::CurvedShape<S> && ph::MovingShape<S> &&
                                    requires(S shape) { shape.extrapolate(1.0); };

static_assert(has_all_of_a_shape<complete_shape> && ph::BoundedShape<complete_shape>);
static_assert(has_all_of_a_shape<ph::offset<complete_shape>> && ph::BoundedShape<ph::offset<complete_shape>>);
static_assert(has_all_of_a_shape<ph::complement<complete_shape>> &&
              !ph::BoundedShape<ph::complement<complete_shape>>);
static_assert(has_all_of_a_shape<ph::moving<complete_shape>> &&
              !ph::BoundedShape<ph::moving<complete_shape>>);

using any_shape = ph::runtime::any_shape<2>;
static_assert(ph::gradient_is_unit<any_shape> && ph::CurvedShape<any_shape> && ph::MovingShape<any_shape> &&
              ph::BoundedShape<any_shape>);

// ---- scenes

struct complete_scene {
  static constexpr int dimension = 2;
  using contacts_type = ph::contacts<2, 1>;
  const contacts_type& touched_at(const ph::point<2>&);
  void set_margin(double);
  void reset();
  void remember(const complete_scene&);
  void extrapolate(double);
  [[maybe_unused]] friend ph::status scene_status(const complete_scene&) { return ph::status::ok; }
};

template <class S>
constexpr bool has_status = requires(const S& scene) { scene_status(scene); };
template <class S>
constexpr bool forgets = requires(S& scene) { scene.reset(); };

using held = ph::held_scene<complete_scene>;
static_assert(has_status<held> && forgets<held> && ph::SeesAhead<held> &&
              requires(held& scene) { scene.remember(scene); });
using latest = ph::latest_scene<complete_scene>;
static_assert(has_status<latest> && ph::SeesAhead<latest>);
using with_effect = ph::with_effects<complete_scene, ph::viscous_field<double, 2>>;
static_assert(has_status<with_effect> && forgets<with_effect>);

// ---- models of brakes

struct complete_brake : ph::coulomb_brake<double> {
  double compliance = 0;
};

template <class B>
constexpr bool has_all_of_a_brake =
    ph::InvertibleBrakeModel<B> && ph::Parameters<B> &&
    (requires(const B b) { b.residual; } || requires(const B b) { b.residual(); }) &&
    (requires(const B b) { b.compliance; } || requires(const B b) { b.compliance(); });

static_assert(has_all_of_a_brake<complete_brake>);
static_assert(has_all_of_a_brake<ph::delayed_brake<complete_brake>>);
static_assert(has_all_of_a_brake<ph::compensated_brake<complete_brake>>);
static_assert(has_all_of_a_brake<ph::presliding_brake<complete_brake>>);
// Which checks the parameters itself
static_assert(ph::InvertibleBrakeModel<ph::any_brake<complete_brake, ph::coulomb_brake<double>>>);

}  // namespace
