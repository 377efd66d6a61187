#!/usr/bin/env bash
set -eu
umask 077
cmake -B build && cmake --build build --target package
sudo apt install ./build/libpassive-haptics-dev_*_all.deb

documents=$ROOT/usr/share/doc/libpassive-haptics-dev
test -s "$documents/copyright"
gunzip -c "$documents/changelog.Debian.gz" | grep "^libpassive-haptics-dev ("
if find "$ROOT" -mindepth 1 -type d ! -perm -005 | grep .; then exit 1; fi
