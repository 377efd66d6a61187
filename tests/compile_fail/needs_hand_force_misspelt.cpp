// expect: passive_haptics: a member of the law is spelt almost as `needs_hand_force`
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;
using arm = ph::tendon_two_link<double>;

struct law {
  static constexpr bool needs_handforce = true;
  template <class T, int D>
  T scale(const ph::contact_situation<T, D>& c) const noexcept {
    return c.hand_force[0] > 0 ? T(1) : T(0);
  }
};

int main() {
  ph::controller control(arm(), ph::brakes_of<arm>(), ph::scene(ph::wall(ph::half_space<2>({0, 1}, {0, -1}))),
                         law());
}
