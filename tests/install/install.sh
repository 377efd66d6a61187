#!/usr/bin/env bash
set -eu
umask 077
cmake -B build && sudo cmake --install build

# Nothing of ours is built, and nothing was looked for that only our tests or benchmarks need.
if cmake --build build | grep -E 'Building|Linking'; then exit 1; fi
if grep -E '^(GTest|benchmark)_DIR' build/CMakeCache.txt; then exit 1; fi

# Whatever the umask is, all may read it.
if find "$ROOT" -mindepth 1 -type d ! -perm -005 | grep .; then exit 1; fi
