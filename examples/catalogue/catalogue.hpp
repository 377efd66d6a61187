/// @file
/// All mechanisms, laws, shapes and brake models of the library by name, with controllers of each mechanism
/// under each law. A program of your own adds what it has:
///
///     ph::runtime::catalogue& all = example::catalogue();
///     all.add_mechanism<crane>("crane");
#pragma once

#include <passive_haptics/runtime/catalogue.hpp>

namespace example {

namespace ph = passive_haptics;

/// The catalogue of this program, filled by the first call. Make that call before threads start.
ph::runtime::catalogue& catalogue();

}  // namespace example
