// expect: passive_haptics needs float and double as they are: on 32-bit x86 compile with -msse2 -mfpmath=sse
#undef __FLT_EVAL_METHOD__
#define __FLT_EVAL_METHOD__ 2
#include <passive_haptics/passive_haptics.hpp>
