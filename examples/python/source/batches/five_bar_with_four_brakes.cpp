// Batches of five_bar_with_four_brakes at a wall that the compiler knows.
#undef PASSIVE_HAPTICS_FLATTEN
#include "../batches_at_walls.hpp"

#include <passive_haptics/mechanism/models/five_bar.hpp>

namespace passive_haptics_python {

using device = ph::five_bar<double, 4>;
PASSIVE_HAPTICS_PYTHON_BATCHES_HERE(device);

}  // namespace passive_haptics_python
