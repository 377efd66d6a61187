// expect: passive_haptics needs IEEE arithmetic: compile without .*-freciprocal-math
#define __RECIPROCAL_MATH__ 1
#include <passive_haptics/passive_haptics.hpp>
