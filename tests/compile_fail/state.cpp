#include "prelude.hpp"

#ifdef time_in_nanoseconds
// error: passive_haptics: the state needs a member time, in seconds and of a floating-point type
struct state {
  std::int64_t time = 0;
  V2 q, qd, hand_force;
};
void cycle() { run(table(), ph::brakes_of<table>(), room, ph::direct_control(), state()); }
#endif

#ifdef state_of_another_mechanism
// error: passive_haptics: the state needs members q and qd, each a vector<scalar, dof> exactly
using in_float = ph::device_state<ph::xy_table<float>>;
void cycle() { run(table(), ph::brakes_of<table>(), room, ph::no_direct_control(), in_float()); }
#endif
