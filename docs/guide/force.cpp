#include <passive_haptics/passive_haptics.hpp>

#include <cmath>
#include <iostream>

namespace ph = passive_haptics;
using device = ph::two_link<double>;

int main() {
  const device arm({.length_1 = 1, .length_2 = 1});
  const auto E = ph::brake_jacobian(arm, {ph::radians(45.0), ph::radians(90.0)});
  const ph::vector<double, 2> s(-1, 1);  // the handle moves along -y
  const ph::vector<double, 2> Fd(0.5, 1);

  const auto Fp = ph::nearest_force(E, s, Fd).force;  // (0, 1), the projection on the cone
  std::cout << "nearest force " << Fp.transpose() << " N, gamma "
            << ph::degrees(std::acos(Fp.norm() / Fd.norm())) << " deg\n";

  // The paper's device along its wall y = 0.225 m, forth and back, with brakes of 0.3 N m
  const ph::tendon_two_link<double> tendon;
  const ph::vector<double, 2> limit(0.3, 0.3), out(0, -1);
  const auto pose_at = [&](double x) { return tendon.inverse({x, 0.225}, ph::elbow::left).q; };
  double share_back = 0;
  for (const double way : {1.0, -1.0}) {
    const auto there = ph::displayable(tendon, pose_at(0.1), {way, 0}, out, limit);
    std::cout << "at x = 0.1 m: gamma " << ph::degrees(there.angle) << " deg, up to " << there.max_force
              << " N, by force approximation " << there.max_approximated_force << " N\n";

    const auto along = [&](double u) {
      return ph::path_point<ph::tendon_two_link<double>>{pose_at(0.045 + 0.125 * u), {way, 0}, out};
    };
    share_back = ph::undisplayable_share(tendon, along);
    std::cout << "nothing on " << share_back << " of the way, less than 2 N on "
              << ph::undisplayable_share(tendon, along, limit, 2.0) << "\n";
    std::cout << "a hand of 2 N sinks " << 1e3 * ph::sink_depth(tendon, along, limit, 2.0) << " mm\n";
  }
  return std::abs(Fp.y() - 1) < 1e-12 && share_back > 0.9 ? 0 : 1;
}
