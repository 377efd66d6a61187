/// The version; the build reads it from here.
#pragma once

#define PASSIVE_HAPTICS_VERSION_MAJOR 0  ///< Incremented with incompatible changes, from 1.0 on.
#define PASSIVE_HAPTICS_VERSION_MINOR 3  ///< Incremented with features; before 1.0 also incompatible changes.
#define PASSIVE_HAPTICS_VERSION_PATCH 0  ///< Incremented with corrections.
