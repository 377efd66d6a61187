// Device files of all programs here: the only source that needs toml++.
#include <passive_haptics/runtime/device_file/definitions.hpp>
