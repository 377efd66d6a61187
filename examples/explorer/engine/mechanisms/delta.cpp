// A delta: three arms that move a platform in space without turning it.
#include "planar_arm.hpp"

#include <passive_haptics/mechanism/models/delta.hpp>

namespace explorer {
namespace {

struct description : described {
  using mechanism = ph::delta<double>;
  using parameters = ph::delta_parameters<double>;
  using joints = ph::vector<double, 3>;
  using place = ph::vector<double, 3>;
  static constexpr const char *id = "delta", *label = "Delta";
  static constexpr const char* scene = "plane:0,0,-0.15,0,0,1";

  static mechanism make(const parameters& p) { return mechanism(p); }
  static joints start() { return {0.5, 0.62, 0.71}; }
  static ph::joint_solution<double, 3> inverse(const mechanism& model, const place& x, const joints&) {
    return model.inverse(x);
  }
  static void draw(const mechanism& model, const joints& q, drawing& to) {
    const auto& p = model.parameters();
    const place middle = model.position(q), up(0, 0, 1);
    const double size = brake_share * p.upper_arm;
    place base[3], out[3], aside[3];
    for (int i = 0; i < 3; ++i) {
      const ph::vector<double, 2> e = direction_at(i, 3);
      out[i] = place(e[0], e[1], 0);
      aside[i] = ph::cross(up, out[i]);
      base[i] = p.base_radius * out[i];
      to.add(item_kind::ground, -1, base[i], base[i], size);
    }
    for (int i = 0; i < 3; ++i) {
      const place elbow = base[i] + p.upper_arm * (std::cos(q[i]) * out[i] - std::sin(q[i]) * up);
      const place end = middle + p.platform_radius * out[i];
      to.add(item_kind::link, i, base[i], elbow);
      for (const double side : {-1.0, 1.0})  // both rods of the parallelogram
        to.add(item_kind::link, 3 + i, elbow + side * size * aside[i], end + side * size * aside[i]);
      to.add(item_kind::platform, i, end, middle + p.platform_radius * out[(i + 1) % 3]);
      to.add(item_kind::platform, 3 + i, base[i], base[(i + 1) % 3]);
      to.add_turning(item_kind::joint, i, base[i], aside[i]);
      to.add_turning(item_kind::brake, i, base[i], aside[i], size, q[i]);
    }
    to.add(item_kind::handle, -1, middle, middle);
  }
  static double reach(const mechanism& model) {
    const auto& p = model.parameters();
    return p.base_radius + p.upper_arm + p.forearm;
  }
};

}  // namespace

mechanism_entry delta_entry() { return entry_of<description>(); }

}  // namespace explorer
