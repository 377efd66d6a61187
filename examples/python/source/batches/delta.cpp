// Batches of delta at a wall that the compiler knows.
#undef PASSIVE_HAPTICS_FLATTEN
#include "../batches_at_walls.hpp"

#include <passive_haptics/mechanism/models/delta.hpp>

namespace passive_haptics_python {

using device = ph::delta<double>;
PASSIVE_HAPTICS_PYTHON_BATCHES_HERE(device);

}  // namespace passive_haptics_python
