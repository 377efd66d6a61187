// Stands in for the flags of a compiler, so it comes before the library.

#ifdef fast_math
// error: passive_haptics needs IEEE arithmetic: compile this file without -ffast-math
#define __FAST_MATH__ 1
#endif

#ifdef associative_math
// error: passive_haptics needs IEEE arithmetic: compile without
#define __ASSOCIATIVE_MATH__ 1
#endif

#ifdef reciprocal_math
// error: passive_haptics needs IEEE arithmetic: compile without
#define __RECIPROCAL_MATH__ 1
#endif

#ifdef excess_precision
// error: passive_haptics needs float and double as they are: on 32-bit x86 compile with -msse2 -mfpmath=sse
#undef __FLT_EVAL_METHOD__
#define __FLT_EVAL_METHOD__ 2
#endif

#ifdef old_eigen
// error: passive_haptics needs Eigen 3.4 or newer: this file includes an older one
#include <Eigen/Core>
#undef EIGEN_MAJOR_VERSION
#define EIGEN_MAJOR_VERSION 3
#endif

#include <passive_haptics/passive_haptics.hpp>
