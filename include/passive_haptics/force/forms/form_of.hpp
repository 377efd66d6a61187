/// @file
/// The form of a device's forces: one of three, each with all its operations in a file of its own.
#pragma once

#include <passive_haptics/force/forms/generator_form.hpp>
#include <passive_haptics/force/forms/half_space_form.hpp>
#include <passive_haptics/force/forms/settled_form.hpp>
#include <passive_haptics/mechanism/self_motion.hpp>

#include <type_traits>

namespace passive_haptics {

/// The form of M: by half-spaces (n = m = d), by generators (n = d, another m), or settled (n > d).
template <class M>
using form_of =
    std::conditional_t<Settles<M>, settled_form<M>,
                       std::conditional_t<M::brake_count == M::dof, half_space_form<M>, generator_form<M>>>;

/// F = G t in pose q.
template <class M>
auto force_map_of(const M& mechanism, const joint_vector<M>& q) {
  static_assert(is_mechanism<M, explain>());
  return form_of<M>::map(mechanism_pose<M>(mechanism, q), passive_haptics::brake_jacobian(mechanism, q));
}

}  // namespace passive_haptics
