// An arm in space: a turning base, shoulder and elbow, a brake on each.
#include "arm_parameters.hpp"
#include "numeric_inverse.hpp"
#include "planar_arm.hpp"

namespace explorer {
namespace {

struct description : described {
  using mechanism = ph::serial_chain_with_inertia<double, 3, 3>;
  using parameters = arm_parameters;
  using joints = ph::vector<double, 3>;
  using place = ph::vector<double, 3>;
  static constexpr const char *id = "spatial_3r", *label = "An arm in space";
  static constexpr bool has_replay = false;
  static constexpr const char* scene = "plane:0,0,0.05,0,0,1";

  // In the zero pose: a column, then two links along x. Base about z, shoulder and elbow about -y, so that
  // positive angles lift the arm.
  static mechanism make(const parameters& p) {
    const place base(0, 0, 0), shoulder(0, 0, p.length_1), elbow(p.length_2, 0, p.length_1),
        handle(p.length_2 + p.length_3, 0, p.length_1), up(0, 0, 1), right(0, -1, 0);
    return chain_of<3>({ph::revolute_joint<double>(up, base), ph::revolute_joint<double>(right, shoulder),
                        ph::revolute_joint<double>(right, elbow)},
                       {base, shoulder, elbow, handle}, p);
  }
  static joints start() { return {0.3, 0.3, -1.6}; }
  static ph::joint_solution<double, 3> inverse(const mechanism& model, const place& x, const joints& q) {
    return numeric_inverse(model, x, q, reach(model));
  }
  static void draw(const mechanism& model, const joints& q, drawing& to) {
    const auto pose = model.pose(q);
    const place points[] = {pose.point[0], pose.point[1], pose.point[2], pose.handle};
    const double size = brake_share * reach(model) / 2;
    to.add(item_kind::ground, -1, points[0], points[0], 1.5 * size);
    for (int i = 0; i < 3; ++i) to.add(item_kind::link, i, points[i], points[i + 1]);
    for (int i = 0; i < 3; ++i) to.add_turning(item_kind::joint, i, points[i], pose.rotation[std::size_t(i)]);
    for (int i = 0; i < 3; ++i)
      to.add_turning(item_kind::brake, i, points[i], pose.rotation[std::size_t(i)], size, q[i]);
    to.add(item_kind::handle, -1, points[3], points[3]);
  }
  static double reach(const mechanism& model) { return model.position(joints(0, 0, 0)).norm(); }
};

}  // namespace

mechanism_entry spatial_3r_entry() { return entry_of<description>(); }

}  // namespace explorer
