#!/usr/bin/env bash
# What including the library costs a user's build: seconds of CPU of the compiler, the median of five.
set -eu
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
compiler=${CXX:-g++}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
flags="-std=c++20 -O2 -DNDEBUG -I$root/include $(pkg-config --cflags-only-I eigen3 2>/dev/null | sed 's/-I/-isystem /g')"

echo '#include <Eigen/Dense>' >"$folder/Eigen_Dense.cpp"
echo '#include <passive_haptics/passive_haptics.hpp>' >"$folder/umbrella.cpp"
cat >"$folder/one_step.cpp" <<'END'
#include <passive_haptics/passive_haptics.hpp>
namespace ph = passive_haptics;
using arm = ph::tendon_two_link<double>;
using loop = ph::controller<arm, ph::scene<ph::half_space<2>>, ph::direct_control>;
void cycle(loop& control, const ph::device_state<arm>& state, ph::step_result<arm>& result) {
  result = control(state);
}
END

TIMEFORMAT=%U
median() {
  for _ in 1 2 3 4 5; do { time "$compiler" $flags -c "$folder/$1.cpp" -o /dev/null; } 2>&1; done | sort -n | sed -n 3p
}
printf '%-28s %s\n' "$("$compiler" --version | head -1)" '-O2, s of CPU'
eigen=$(median Eigen_Dense)
umbrella=$(median umbrella)
step=$(median one_step)
printf '%-28s %6.2f\n' '<Eigen/Dense>' "$eigen" 'the umbrella header' "$umbrella" 'the same and one step' "$step"
awk -v e="$eigen" -v u="$umbrella" -v s="$step" \
  'BEGIN { printf "summary: the umbrella header %.2fx of <Eigen/Dense>; a source with one step %.2f s\n", u / e, s }'
