/// The program replay for the mechanisms and laws of a catalogue.
#pragma once

#include <passive_haptics/runtime/catalogue.hpp>

namespace example {

/// main() of replay; returns the exit status. The device of a log is that of --config, else the device file
/// next to it (device_name). Without a log it replays half a second of generated motion of the paper's device
/// under direct_control.
int replay_program(int argc, char** argv, const passive_haptics::runtime::catalogue& all);

}  // namespace example
