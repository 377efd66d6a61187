/// A simulated device: a mechanism with inertia, brakes, and a hand's mass on its handle.
#pragma once

#include <passive_haptics/core/linear/cholesky.hpp>
#include <passive_haptics/core/linear/lane_products.hpp>
#include <passive_haptics/plant/box_friction.hpp>
#include <passive_haptics/plant/moving_device.hpp>
#include <passive_haptics/plant/simulated_device_declaration.hpp>

#include <concepts>
#include <utility>

namespace passive_haptics {

namespace detail {

struct simulated_device_header {};

struct braces {};  // for an argument in braces, which has no type

template <class T, class To>
concept fits_as = std::same_as<T, braces> || std::convertible_to<T, To>;

template <class M, class Brakes, class Mass, class Q>
concept simulated_device_arguments =
    Mechanism<M> && (fits_as<Brakes, brakes_of<M>> || requires { std::tuple_size<Brakes>::value; }) &&
    fits_as<Mass, typename M::scalar> && fits_as<Q, joint_vector<M>>;

// False, or an error for wrong arguments.
template <class M, class Brakes, class Mass, class Q>
consteval bool rejects_simulated_device() {
  static_assert(
      simulated_device_arguments<M, Brakes, Mass, Q>,
      "passive_haptics: the arguments of a simulated_device are (mechanism, brakes, hand_mass, q), in "
      "this order.");
  return false;
}

}  // namespace detail

/// Simulated device M qdd + c = J^T Fh + T^T t. The brakes are Coulomb friction with exact stick and viscous
/// drag, by the Model of each brake; its compliance is a spring in series with the friction. Semi-implicit
/// Euler on impulses, first order in dt: the resistances at the old rates, then the new rates (friction and
/// drag implicit), then positions. The hand's mass moves with the handle; a sensor between them measures the
/// force that reaches the device.
template <class M, class Model>
  requires(detail::has_simulated_device<M>())
class simulated_device : public moving_device<M, Model> {
  using base = moving_device<M, Model>;

 public:
  using scalar = typename M::scalar;  ///< Scalar of the mechanism.

  /// At rest at q, with ideal_brakes; hand_mass [kg] moves with the handle. Throws std::invalid_argument with
  /// the text of validate(brakes), or if the mass is negative or not finite.
  simulated_device(M mechanism, const brakes_of<M>& brakes, scalar hand_mass, const joint_vector<M>& q)
    requires std::same_as<Model, coulomb_brake<scalar>>
      : simulated_device(std::move(mechanism), ideal_brakes(require_valid(brakes)), hand_mass, q) {}

  /// A device with brakes that may differ from the controller's parameters.
  template <std::same_as<brake_models_of<M, Model>> RealBrakes>  // a template, so that {} means brakes_of<M>
  simulated_device(M mechanism, const RealBrakes& brakes, scalar hand_mass, const joint_vector<M>& q)
      : base(std::move(mechanism), brakes, hand_mass, q) {}

  /// Rejects other arguments.
  template <class Brakes = detail::braces, class Mass, class Q = detail::braces>
    requires(detail::rejects_simulated_device<M, Brakes, Mass, Q>())
  simulated_device(const M&, const Brakes&, const Mass&, const Q&) = delete;

  using base::set_motion;

  /// Advances by dt [s] under commanded capacities [N m] and the muscle force of the hand [N]; not if dt is
  /// not a finite number > 0. Diverges to NaN if dt exceeds about twice the minimum time constant of the
  /// hand.
  void advance(scalar dt, const brake_vector<M>& capacity, const task_vector<M>& muscle_force) {
    if (valid_time_step(dt) == scalar(0)) return;
    const joint_vector<M>&q = this->q(), &qd = this->qd();
    const step now = this->begin_step(dt, capacity, muscle_force);
    const joint_matrix& mass = this->mass();
    const matrix<scalar, M::dof, M::brake_count> Tt = transposed(now.T);
    const joint_vector<M> drive =
        transposed_times(this->jacobian(), now.device_force) - this->mechanism().bias_torque(q, qd);

    // (M + dt T^T B T) qd' = M qd + dt (J^T F - c) + T^T p, with B the drag and p the impulses of friction
    const transmission_matrix<M> drag = scaled_rows(dt * (now.commanded_drag + now.residual_drag), now.T);
    const cholesky<scalar, M::dof> inverse_mass(mass + Tt * drag);
    const joint_vector<M> free = inverse_mass.solve(joint_vector<M>(mass * qd + dt * drive));
    const brake_vector<M> p = friction_impulses(now, now.T * inverse_mass.solve(Tt), now.T * free);
    this->end_step(now, p, joint_vector<M>(free + inverse_mass.solve(joint_vector<M>(Tt * p))));
  }

 private:
  using step = typename base::step;
  using joint_matrix = matrix<scalar, M::dof, M::dof>;
  using brake_matrix = matrix<scalar, M::brake_count, M::brake_count>;

  // Impulses of friction, with w0 the rates of the brakes' axes without it and A the rates for each N m s.
  brake_vector<M> friction_impulses(const step& now, brake_matrix A, brake_vector<M> w0) const {
    // A shaft of compliance c does not slip if w = -c (p / dt - t) / dt, with t the friction before: the
    // condition of stick with A + c / dt^2 for A and w0 - c t / dt for w0
    const brake_vector<M> give = this->compliance() / (now.dt * now.dt);
    for (int i = 0; i < M::brake_count; ++i) A(i, i) += give[i];
    w0 -= now.dt * entrywise_product(give, this->friction());
    const brake_vector<M> limit = now.dt * now.limit;
    if constexpr (M::brake_count > M::dof)
      return solve_redundant_box_friction<scalar, M::brake_count>(A, w0, limit).impulse;
    else return solve_box_friction<scalar, M::brake_count>(A, w0, limit).impulse;
  }
};

/// Deduces Model from an array with one model for each brake.
template <class M, class Model, std::size_t Brakes>
simulated_device(M, const std::array<Model, Brakes>&, typename M::scalar, const joint_vector<M>&)
    -> simulated_device<M, Model>;

/// Rejects arguments in another order.
template <class M, class Brakes = detail::braces, class Mass, class Q = detail::braces>
  requires(detail::rejects_simulated_device<M, Brakes, Mass, Q>())
simulated_device(M, Brakes, Mass, Q) -> simulated_device<M, coulomb_brake<double>>;

}  // namespace passive_haptics
