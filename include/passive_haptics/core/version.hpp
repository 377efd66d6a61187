/// @file
/// The one source of the version; the build reads it from here.
#pragma once

#define PASSIVE_HAPTICS_VERSION_MAJOR 0  ///< Changes with every break of the interface, from 1.0 on.
#define PASSIVE_HAPTICS_VERSION_MINOR 2  ///< Changes with every feature (and every break before 1.0).
#define PASSIVE_HAPTICS_VERSION_PATCH 0  ///< Changes with every correction.
