/// @file
/// What fills the catalogue besides the lists of mechanisms and laws.
#pragma once

#include <passive_haptics/runtime/catalogue.hpp>

namespace example {

void add_shapes(passive_haptics::runtime::catalogue& all);
void add_effects(passive_haptics::runtime::catalogue& all);
void add_brake_models(passive_haptics::runtime::catalogue& all);
/// Of CMakeLists.txt: controllers and plants of each kind of mechanism, a source each.
void compile_all_kinds(passive_haptics::runtime::catalogue& all);

}  // namespace example
