/// Selection of the form of a device's forces. Each of the three forms has all its operations in one file.
#pragma once

#include <passive_haptics/force/forms/generator_form.hpp>
#include <passive_haptics/force/forms/half_space_form.hpp>
#include <passive_haptics/force/forms/settled_form.hpp>
#include <passive_haptics/mechanism/self_motion.hpp>

#include <type_traits>

namespace passive_haptics {

/// The form of M: half-spaces (n = m = d), generators (n = d, m != d), or settled (n > d).
template <class M>
using form_of =
    std::conditional_t<Settles<M>, settled_form<M>,
                       std::conditional_t<M::brake_count == M::dof, half_space_form<M>, generator_form<M>>>;

/// Map F = G t in pose q.
template <class M>
auto force_map_of(const M& mechanism, const joint_vector<M>& q) {
  static_assert(is_mechanism<M, explain>());
  return form_of<M>::map(mechanism_pose<M>(mechanism, q), passive_haptics::brake_jacobian(mechanism, q));
}

}  // namespace passive_haptics
