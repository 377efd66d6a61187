// Three links in a plane, a brake on each joint: a device with self-motion.
#include "arm_parameters.hpp"
#include "numeric_inverse.hpp"
#include "planar_arm.hpp"

namespace explorer {
namespace {

struct description : described {
  using mechanism = ph::serial_chain_with_inertia<double, 3, 2>;
  using parameters = arm_parameters;
  using joints = ph::vector<double, 3>;
  static constexpr const char *id = "planar_3r", *label = "Three links in the plane, one more than needed";
  static constexpr bool has_replay = false;
  static constexpr const char* scene = "plane:0,0.2,0,-1";

  static mechanism make(const parameters& p) {
    const auto geometry = ph::planar_arm(std::array{p.length_1, p.length_2, p.length_3});
    const auto& j = geometry.joints;
    return chain_of<2>(j, {j[0].point, j[1].point, j[2].point, geometry.handle}, p);
  }
  static joints start() { return {2.13, -1.12, -1.06}; }
  static ph::joint_solution<double, 3> inverse(const mechanism& model, const ph::vector<double, 2>& x,
                                               const joints& q) {
    return numeric_inverse(model, x, q, reach(model));
  }
  static void draw(const mechanism& model, const joints& q, drawing& to) {
    const auto pose = model.pose(q);
    const drawing::place points[] = {drawing::in_plane(pose.point[0]), drawing::in_plane(pose.point[1]),
                                     drawing::in_plane(pose.point[2]), drawing::in_plane(pose.handle)};
    const double size = brake_share * reach(model) / 2;
    draw_links(to, points, size);
    for (int i = 0; i < 3; ++i) to.add_turning(item_kind::brake, i, points[i], out_of_plane(), size, q[i]);
  }
  static double reach(const mechanism& model) { return model.position(joints(0, 0, 0)).norm(); }
};

}  // namespace

mechanism_entry planar_3r_entry() { return entry_of<description>(); }

}  // namespace explorer
