/// @file
/// The program replay, for the mechanisms and laws of a catalogue.
#pragma once

#include <passive_haptics/runtime/catalogue.hpp>

namespace example {

/// The whole program; its exit status. Without a device file it replays the paper's device under
/// direct_control, without a log half a second of that device, made up.
int replay_program(int argc, char** argv, const passive_haptics::runtime::catalogue& all);

}  // namespace example
