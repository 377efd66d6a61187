// The device files of all programs here: no other source needs toml++.
#include <passive_haptics/runtime/device_file/definitions.hpp>
