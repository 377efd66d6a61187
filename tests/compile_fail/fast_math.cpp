// expect: passive_haptics needs IEEE arithmetic: compile this file without -ffast-math
#define __FAST_MATH__ 1
#include <passive_haptics/passive_haptics.hpp>
