/// @file
/// Which control cycles can be computed for several states at once, in packs.
#pragma once

#include <passive_haptics/control/control_law.hpp>
#include <passive_haptics/core/scalar/pack_sine_cosine.hpp>
#include <passive_haptics/scene/scene.hpp>

#include <concepts>

namespace passive_haptics::detail {

// Two joints and two brakes in the plane, in double: closed forms without a branch.
template <class M>
concept is_planar_with_two_brakes =
    std::same_as<typename M::scalar, double> && M::dof == 2 && M::task_dimension == 2 && M::brake_count == 2;

// A mechanism that says that its functions take packs; one that was made of it may have hidden some of them.
template <class M, class T = pack<double, native_pack_width<double>>>
concept takes_packs_of_joints =
    is_planar_with_two_brakes<M> && BranchFree<M> && !transmission_depends_on_pose<M> &&
    ((has_pose<M> && requires(const M mechanism, const vector<T, 2> q) {
       { mechanism.position(mechanism.pose(q)) } -> ExactVector<T, 2>;
       { mechanism.jacobian(mechanism.pose(q)) } -> ExactMatrix<T, 2, 2>;
     }) || (!has_pose<M> && requires(const M mechanism, const vector<T, 2> q) {
       { mechanism.position(q) } -> ExactVector<T, 2>;
       mechanism.jacobian();
     }));

// The shape of a scene of one wall.
template <class S>
struct only_shape_of {
  using type = void;
};
template <class Shape>
struct only_shape_of<static_scene<Shape>> {
  using type = Shape;
};
template <class Shape, class T = pack<double, native_pack_width<double>>>
concept takes_packs_of_points =
    BranchFree<Shape> && gradient_is_unit<Shape> && requires(const Shape shape, const vector<T, 2> x) {
      { shape.distance(x) } -> std::same_as<T>;
      { shape.gradient(x) } -> ExactVector<T, 2>;
    };
// One wall at rest, whose shape takes packs.
template <class S>
concept is_wall_for_packs =
    takes_packs_of_points<typename only_shape_of<S>::type> && !MovingShape<typename only_shape_of<S>::type>;
// The wall of such a scene.
template <class Shape>
const wall<Shape>& only_wall(const static_scene<Shape>& scene) {
  const wall<Shape>* found = nullptr;
  scene.for_each([&](int, const wall<Shape>& w) { found = &w; });
  return *found;
}

// Brakes that are all on, and whose limits do not depend on their rates.
template <class B, class M>
concept are_brakes_for_packs =
    !names_torque_interval<B> && !requires(const B brakes, const brake_vector<M> w) { brakes.at(w); };

// Whether the cycles of several states can be one cycle of packs.
template <class M, class S, class L, class B>
concept Packable = takes_packs_of_joints<M> && is_wall_for_packs<S> && ScalingLaw<L> && BranchFree<L> &&
                   are_brakes_for_packs<B, M>;

}  // namespace passive_haptics::detail
