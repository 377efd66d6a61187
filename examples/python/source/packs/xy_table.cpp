// Batches of xy_table, several states at a time: here each is one function, as FLATTEN makes it.
#undef PASSIVE_HAPTICS_FLATTEN
#include "../packs.hpp"

#include <passive_haptics/mechanism/models/xy_table.hpp>

namespace passive_haptics_python {

using device = ph::xy_table<double>;
PASSIVE_HAPTICS_PYTHON_PACKED(device, ph::direct_control)
PASSIVE_HAPTICS_PYTHON_PACKED(device, ph::saturated_direct_control)

}  // namespace passive_haptics_python
