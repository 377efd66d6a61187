// brake_driver and replay with a mechanism and a law of your own.
#include <catalogue/catalogue.hpp>
#include <driver_program.hpp>
#include <log/replay_program.hpp>

#include <cmath>
#include <string_view>

namespace ph = passive_haptics;

struct crane {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  using numbers = ph::vector<double, 2>;

  template <class S>
  ph::vector<S, 2> position(const ph::vector<S, 2>& q) const {
    using std::cos, std::sin;
    return {q[1] * cos(q[0]), q[1] * sin(q[0])};  // a boom that turns and slides
  }

  // For a simulation: 1 kg at its end
  ph::matrix<double, 2, 2> mass_matrix(const numbers& q) const {
    return ph::matrix<double, 2, 2>{{q[1] * q[1], 0}, {0, 1}};
  }
  numbers bias_torque(const numbers& q, const numbers& qd) const {
    return {2 * q[1] * qd[1] * qd[0], -q[1] * qd[0] * qd[0]};
  }
  numbers bias_acceleration(const numbers& q, const numbers& qd) const {
    const double c = std::cos(q[0]), s = std::sin(q[0]);
    const double along = -q[1] * qd[0] * qd[0], across = 2 * qd[1] * qd[0];
    return {c * along - s * across, s * along + c * across};
  }
};

struct soft_control {
  double share = 0.5;  // of the force that the brakes can display

  static constexpr auto members() {
    return ph::member_table(ph::member("share", &soft_control::share, "1", ph::range::between(0, 1)));
  }
  template <class T, int D>
  T scale(const ph::contact_situation<T, D>&) const noexcept {
    return T(share);
  }
};

int main(int argc, char** argv) {
  ph::runtime::catalogue& all = example::catalogue();
  all.add_mechanism<crane>("crane");
  constexpr ph::runtime::named_law<soft_control> soft{"soft_control"};
  all.add_laws(soft);
  all.compile_for<crane>(soft);

  if (argc > 1 && argv[1] == std::string_view("replay"))
    return example::replay_program(argc - 1, argv + 1, all);
  return example::driver_program(argc, argv);
}
