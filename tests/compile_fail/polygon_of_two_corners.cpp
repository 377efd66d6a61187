// expect: passive_haptics: a convex_polygon has three corners or more
#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/scene/shapes/convex_polygon.hpp>

int main() { passive_haptics::convex_polygon<2> line({{{0, 0}, {1, 0}}}); }
