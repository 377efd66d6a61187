// The program replay with a mechanism of your own.
#include <catalogue/catalogue.hpp>
#include <log/replay_program.hpp>

struct crane {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;

  template <class S>
  passive_haptics::vector<S, 2> position(const passive_haptics::vector<S, 2>& q) const {
    using std::cos, std::sin;
    return {q[1] * cos(q[0]), q[1] * sin(q[0])};  // a boom that turns and slides
  }
};

int main(int argc, char** argv) {
  example::catalogue().add_mechanism<crane>("crane");
  return example::replay_program(argc, argv, example::catalogue());
}
