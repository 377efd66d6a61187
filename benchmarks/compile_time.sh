#!/usr/bin/env bash
# What including the library costs a user's build: CPU time of the compiler, the least of ten, one source after the
# other in each round. Only ratios mean anything.
set -eu
unset CDPATH
export LC_ALL=C  # times have a decimal point
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
compiler=${CXX:-g++}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
flags=(-std=c++20 "-I$root/include" $(pkg-config --cflags-only-I eigen3 2>/dev/null | sed 's/-I/-isystem /g'))

echo '#include <Eigen/Dense>' >"$folder/Eigen_Dense.cpp"
echo '#include <passive_haptics/passive_haptics.hpp>' >"$folder/umbrella.cpp"
cat >"$folder/one_step.cpp" <<'END'
#include <passive_haptics/passive_haptics.hpp>
namespace ph = passive_haptics;
using arm = ph::tendon_two_link<double>;
using loop = ph::controller<arm, ph::static_scene<ph::half_space<2>>, ph::direct_control>;
void cycle(loop& control, const ph::device_state<arm>& state, ph::step_result<arm>& result) {
  result = control(state);
}
END

# seconds NAME FLAG...: CPU time, user and system.
TIMEFORMAT='%U %S'
seconds() {
  { time "$compiler" "${flags[@]}" "${@:2}" "$folder/$1.cpp"; } 2>&1 | awk '{ print $1 + $2 }'
}
# Names the least of each row of $folder/times, "row seconds".
least() { awk -v row="$1" '$1 == row && (!found || $2 < best) { best = $2; found = 1 } END { print best }' "$folder/times"; }

for _ in 1 2 3 4 5 6 7 8 9 10; do
  echo "dense $(seconds Eigen_Dense -fsyntax-only)"
  echo "umbrella $(seconds umbrella -fsyntax-only)"
  echo "step $(seconds one_step -O2 -DNDEBUG -c -o /dev/null)"
done >"$folder/times"
printf '%s\n%-46s %8s %8s\n' "$("$compiler" --version | head -1)" '' 's of CPU' 'x Eigen'
for row in 'dense <Eigen/Dense>, -fsyntax-only' 'umbrella the umbrella header, -fsyntax-only' \
  'step the same and one step, -O2'; do
  awk -v e="$(least dense)" -v t="$(least "${row%% *}")" -v name="${row#* }" \
    'BEGIN { printf "%-46s %8.2f %8.2f\n", name, t, t / e }'
done
awk -v e="$(least dense)" -v u="$(least umbrella)" -v s="$(least step)" \
  'BEGIN { printf "summary: the umbrella header %.2fx of <Eigen/Dense>; a source with one step %.2fx\n", u / e, s / e }'
