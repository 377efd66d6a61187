// Batches of xy_table at a wall that the compiler knows.
#undef PASSIVE_HAPTICS_FLATTEN
#include "../batches_at_walls.hpp"

#include <passive_haptics/mechanism/models/xy_table.hpp>

namespace passive_haptics_python {

using device = ph::xy_table<double>;
PASSIVE_HAPTICS_PYTHON_BATCHES_HERE(device);

}  // namespace passive_haptics_python
