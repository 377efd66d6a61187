// expect: not a constant expression|not an integral constant expression|non-constant|call to non-.?constexpr
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

static_assert(ph::describe<ph::xy_table<double>>().has("transmision"));

int main() {}
