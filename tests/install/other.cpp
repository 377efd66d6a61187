#include <passive_haptics/passive_haptics.hpp>

int major_version_seen_elsewhere() { return PASSIVE_HAPTICS_VERSION_MAJOR; }
