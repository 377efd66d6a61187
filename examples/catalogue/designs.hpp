/// Design functions and wall-following experiments for all mechanisms of the catalogue: link
/// passive_haptics_designs.
#pragma once

#include <passive_haptics/runtime/any_design.hpp>

namespace example {

/// The list of this program, filled by the first call, which must precede threads.
passive_haptics::runtime::design_list& designs();

}  // namespace example
