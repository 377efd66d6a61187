/// Mechanisms, laws, shapes and brake models of the library by name, with controllers of each mechanism under
/// each law. A program adds its own:
///
///     ph::runtime::catalogue& all = example::catalogue();
///     all.add_mechanism<crane>("crane");
#pragma once

#include <passive_haptics/runtime/catalogue.hpp>

namespace example {

namespace ph = passive_haptics;

/// The catalogue of this program, filled by the first call, which must precede threads.
ph::runtime::catalogue& catalogue();

}  // namespace example
