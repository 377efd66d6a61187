#!/usr/bin/env bash
set -eu
cmake -B build && cmake --build build --target package
sudo apt install ./build/libpassive-haptics-dev_*_all.deb

cd "$ROOT/usr/share/doc/libpassive-haptics-dev"
test -s copyright
gunzip -c changelog.Debian.gz | grep "^libpassive-haptics-dev ("
