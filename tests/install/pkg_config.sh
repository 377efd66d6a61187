#!/usr/bin/env bash
# pkg_config.sh WARNING...: README's command, by the compiler $CXX.
set -eu
cp "$(dirname "${BASH_SOURCE[0]}")"/{consumer,other}.cpp .
warnings=("$@")
c++() { "$CXX" "${warnings[@]}" "$@"; }

c++ -std=c++20 -O2 -DNDEBUG $(pkg-config --cflags passive_haptics) consumer.cpp other.cpp -o consumer
./consumer
