// brake_driver and replay with a mechanism and a law of your own.
#include "scara.hpp"

#include <catalogue/catalogue.hpp>
#include <driver_program.hpp>
#include <log/replay_program.hpp>

#include <string_view>

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
  all.add_mechanism<scara>("scara");
  constexpr ph::runtime::named_law<soft_control> soft{"soft_control"};
  all.add_laws(soft);
  all.compile_for<scara>(soft);

  if (argc > 1 && argv[1] == std::string_view("replay"))
    return example::replay_program(argc - 1, argv + 1, all);
  return example::driver_program(argc, argv);
}
