#!/bin/sh
# 300 experiments by GNU parallel, from the top folder of a clone. Each machine of the list takes one part after the other.
set -eu
machines=${1:-:}
program=build/examples/examples/07_experiments
mkdir -p parts
# Parts
seq 0 2 | parallel --jobs 1 --sshlogin "$machines" --workdir . --joblog parts/log --resume-failed \
  "$program" --first {}00 --last {}99 --output parts
# Merge
"$program" --first 0 --last 299 --merge parts/*.csv
