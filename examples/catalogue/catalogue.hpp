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

/// That of this program, filled at the first call. Not for several threads before that.
ph::runtime::catalogue& catalogue();

}  // namespace example
