/// @file
/// A five-bar with two or four brakes.
#pragma once

#include "planar_arm.hpp"

#include <passive_haptics/mechanism/models/five_bar.hpp>

#include <cmath>

namespace explorer {

/// What does not depend on the number of brakes.
template <int Brakes>
struct five_bars : described {
  using mechanism = ph::five_bar<double, Brakes>;              ///< The mechanism.
  using parameters = ph::five_bar_parameters<double, Brakes>;  ///< Its parameters.
  using joints = ph::vector<double, 2>;                        ///< q

  static constexpr const char* scene = "plane:0,0.1,0,-1";  ///< In the middle of the workspace.
  /// Its mechanism.
  static mechanism make(const parameters& p) { return mechanism(p); }
  /// The handle at (0.01, 0.098) m.
  static joints start() { return {2.239309785437203, 0.8093484082683855}; }
  /// Elbows outwards; the other assembly stands in the parameters.
  static ph::joint_solution<double, 2> inverse(const mechanism& model, const joints& x, const joints&) {
    return model.inverse(x);
  }
  /// Both legs.
  static void draw(const mechanism& model, const joints& q, drawing& to) {
    const auto& p = model.parameters();
    const double size = brake_share * p.proximal_1;
    const drawing::place handle = drawing::in_plane(model.position(q));
    drawing::place base[2], elbow[2];
    const double half = p.base_distance / 2, length[2] = {p.proximal_1, p.proximal_2};
    for (int i = 0; i < 2; ++i) {
      base[i] = drawing::place(i == 0 ? -half : half, 0, 0);
      elbow[i] = base[i] + length[i] * drawing::place(std::cos(q[i]), std::sin(q[i]), 0);
      to.add(item_kind::ground, -1, base[i], base[i], size);
    }
    for (int i = 0; i < 2; ++i) {
      to.add(item_kind::link, i, base[i], elbow[i]);
      to.add(item_kind::link, 2 + i, elbow[i], handle);
      to.add_turning(item_kind::joint, i, base[i], out_of_plane());
      to.add_turning(item_kind::joint, 2 + i, elbow[i], out_of_plane());
      to.add_turning(item_kind::brake, i, base[i], out_of_plane(), size, q[i]);
    }
    if constexpr (Brakes == 4) {  // on the difference and the sum of the base angles, beside the base
      for (int i = 2; i < 4; ++i) {
        const drawing::place beside((i == 2 ? -1 : 1) * (half + 3 * size), -3 * size, 0);
        to.add_turning(item_kind::brake, i, beside, out_of_plane(), size, i == 2 ? q[0] - q[1] : q[0] + q[1]);
      }
    }
    to.add(item_kind::handle, -1, handle, handle);
  }
  /// Of a leg [m].
  static double reach(const mechanism& model) {
    const auto& p = model.parameters();
    return p.proximal_1 + p.distal_1;
  }
};

}  // namespace explorer
