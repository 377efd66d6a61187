// expect: passive_haptics: a convex_polytope has one face or more
#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/scene/shapes/convex_polytope.hpp>

passive_haptics::convex_polytope<3, 0>* all_of_space();

int main() { return static_cast<int>(all_of_space()->face_count); }
