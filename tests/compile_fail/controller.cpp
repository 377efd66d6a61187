#include "prelude.hpp"

#ifdef brakes_first
// error: passive_haptics: the arguments of a controller are (mechanism, brakes, scene, law), in this order:
// the first argument must be a mechanism
ph::controller control(ph::brakes_of<table>(), table(), room, ph::direct_control());
#endif

#ifdef scene_before_the_brakes
// error: passive_haptics: the arguments of a controller are (mechanism, brakes, scene, law), in this order:
// the second argument must be brakes
ph::controller control(table(), room, ph::brakes_of<table>(), ph::direct_control());
#endif

#ifdef law_before_the_scene
// error: passive_haptics: the arguments of a controller are (mechanism, brakes, scene, law), in this order:
// the third argument must be a scene
ph::controller control(table(), ph::brakes_of<table>(), ph::direct_control(), room);
#endif

#ifdef controller_without_a_law
// error: passive_haptics: the arguments of a controller are (mechanism, brakes, scene, law): one is missing
ph::controller control(table(), ph::brakes_of<table>(), room);
#endif
