// expect: passive_haptics needs IEEE arithmetic: compile without .*-fassociative-math
#define __ASSOCIATIVE_MATH__ 1
#include <passive_haptics/passive_haptics.hpp>
