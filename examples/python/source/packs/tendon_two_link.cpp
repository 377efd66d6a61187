// Batches of tendon_two_link, several states at a time: here each is one function, as FLATTEN makes it.
#undef PASSIVE_HAPTICS_FLATTEN
#include "../packs.hpp"

#include <passive_haptics/mechanism/models/tendon_two_link.hpp>

namespace passive_haptics_python {

using device = ph::tendon_two_link<double>;
PASSIVE_HAPTICS_PYTHON_PACKED(device, ph::direct_control)
PASSIVE_HAPTICS_PYTHON_PACKED(device, ph::saturated_direct_control)

}  // namespace passive_haptics_python
