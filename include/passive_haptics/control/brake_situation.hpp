/// @file
/// The device at one instant: what a control cycle knows before it turns to the walls.
#pragma once

#include <passive_haptics/brake/brake_parameters.hpp>
#include <passive_haptics/mechanism/mechanism.hpp>
#include <passive_haptics/scene/shape.hpp>

namespace passive_haptics {

/// The device at one instant; E from brake_jacobian. Lives no longer than the values that it refers to. A law
/// that takes any B also runs on brakes that lack members (brake/brake_concepts.hpp).
template <class M, class EMatrix, class B = brakes_of<M>>
struct brake_situation {
  const M& mechanism;                 ///< The mechanism,
  const B& brakes;                    ///< its brakes.
  double time;                        ///< Now [s],
  const joint_vector<M>& q;           ///< joint positions [rad or m],
  const joint_vector<M>& qd;          ///< their rates [rad/s or m/s],
  const point<M::task_dimension>& x;  ///< the end effector [m].
  const EMatrix& E;                   ///< E = J T^+.
  const brake_vector<M>& w;           ///< Rates of the brakes [rad/s or m/s].
  const task_vector<M>& v;            ///< Velocity of the end effector [m/s], E w.
  const brake_vector<M>& s;           ///< Signs of the brakes.
  const task_vector<M>& hand_force;   ///< Fh [N]; zero where the state has none.
};

}  // namespace passive_haptics
