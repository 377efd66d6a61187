# Sourced by the run scripts: what they share. All output goes to build/.

set -o pipefail
unset CDPATH  # with which cd goes elsewhere, and prints where
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=$PWD/build
jobs=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc 2>/dev/null || echo 2)}
compile_packages="g++ cmake ninja-build libeigen3-dev libboost-dev"
python_packages="g++ cmake ninja-build libeigen3-dev libboost-dev libtomlplusplus-dev python3-dev python3-pybind11 python3-numpy
  python3-matplotlib python3-pip python3-venv python3-wheel"
python=$build/python/venv/bin/python

say() { printf '== %s\n' "$*"; }
fail() { printf 'error: %s\n' "$*" >&2; exit 1; }

# usage_error WHAT ARGUMENT CHOICE...: names a mistyped argument and the choices, first those that look alike.
usage_error() {
  local what=$1 argument=$2 choice
  shift 2
  printf "error: unknown %s '%s'\n" "$what" "$argument" >&2
  for choice; do
    if [[ ${choice:0:3} == "${argument:0:3}" || $choice == *"$argument"* ]]; then
      printf "did you mean '%s'?\n" "$choice" >&2
    fi
  done
  printf 'choices: %s\n' "$*" >&2
  exit 2
}

# Is there what the package brings, whoever installed it?
present() {
  case $1 in
    ninja-build) command -v ninja >/dev/null ;;
    gnuplot-nox) command -v gnuplot >/dev/null ;;
    libeigen3-dev) found_by_dpkg "$1" || found_by_cmake Eigen3 ;;
    libboost-dev) found_by_dpkg "$1" || found_by_cmake Boost ;;
    libgtest-dev) found_by_dpkg "$1" || found_by_cmake GTest ;;
    libassimp-dev) found_by_dpkg "$1" || found_by_cmake assimp ;;
    libmujoco-dev) found_by_dpkg "$1" || found_by_cmake mujoco ;;
    liburdfdom-dev) found_by_dpkg "$1" || found_by_cmake urdfdom ;;
    liborocos-kdl-dev) found_by_dpkg "$1" || found_by_cmake orocos_kdl ;;
    libcli11-dev) found_by_dpkg "$1" || found_by_cmake CLI11 ;;
    libtomlplusplus-dev) found_by_dpkg "$1" || found_by_cmake tomlplusplus ;;
    *-arm-none-eabi-newlib) found_by_dpkg "$1" ;;
    libbenchmark-dev) found_by_dpkg "$1" || found_by_cmake benchmark ;;
    libcomedi-dev) found_by_dpkg "$1" || [[ -f /usr/include/comedilib.h ]] ;;
    qemu-system-x86) command -v qemu-system-x86_64 >/dev/null ;;
    qemu-user) command -v qemu-aarch64 >/dev/null ;;
    g++-aarch64-linux-gnu) command -v aarch64-linux-gnu-g++ >/dev/null ;;
    g++-i686-linux-gnu) command -v i686-linux-gnu-g++ >/dev/null ;;
    g++-mingw-w64-x86-64) command -v x86_64-w64-mingw32-g++ >/dev/null ;;
    wine64) [[ -x /usr/lib/wine/wine64 ]] || command -v wine64 >/dev/null ;;
    emscripten) command -v em++ >/dev/null ;;
    python3) [[ -x /usr/bin/python3 ]] || command -v python3 >/dev/null ;;
    openmpi-bin) command -v mpirun >/dev/null ;;
    nodejs) command -v node >/dev/null ;;
    python3-* | libc++*-dev | doxygen-awesome-css | libjs-katex | fonts-katex) found_by_dpkg "$1" ;;
    clang) command -v clang++ >/dev/null ;;
    llvm) command -v llvm-cov >/dev/null ;;
    libclang-rt-dev) echo 'int main() {}' | clang++ -fsanitize=address -x c++ - -o /dev/null 2>/dev/null ;;
    *) command -v "$1" >/dev/null ;;
  esac
}
found_by_dpkg() { dpkg -s "$1" 2>/dev/null | grep -q '^Status: .* installed$'; }
found_by_cmake() {
  local probe=$build/probe/$1
  made_here "$probe/build" || rm -rf "$probe/build"
  mkdir -p "$probe"
  printf 'cmake_minimum_required(VERSION 3.25)\nproject(probe CXX)\nfind_package(%s REQUIRED)\n' "$1" \
    >"$probe/CMakeLists.txt"
  cmake -S "$probe" -B "$probe/build" >/dev/null 2>&1
}

as_root() { if [[ $(id -u) == 0 ]]; then "$@"; else sudo -n "$@"; fi; }
# apt_get ARGUMENT...: as root. Waits up to ten minutes while another process holds a lock of apt; its option
# DPkg::Lock::Timeout covers neither `update` nor downloads.
apt_get() {
  local errors tries=0
  until { errors=$(as_root env LC_ALL=C DEBIAN_FRONTEND=noninteractive apt-get "$@" 2>&1 >&3); } 3>&1; do
    if [[ $errors != *"Could not get lock"* ]] || ((++tries == 120)); then printf '%s\n' "$errors" >&2; return 1; fi
    ((tries > 1)) || say "waiting for another process. $errors" >&2
    sleep 5
  done
}

# need WHY PACKAGE...: installs what is missing where it may, else says what to install and returns 1.
need() {
  local why=$1 package missing=
  shift
  for package; do present "$package" || missing+=" $package"; done
  [[ $missing ]] || return 0
  if command -v apt-get >/dev/null && as_root true 2>/dev/null; then
    say "installing$missing ($why)"
    if { [[ ${lists_are_new:-} ]] || apt_get update -qq; } && lists_are_new=yes &&
      apt_get install -y --no-install-recommends $missing | sed -nu 's/^\(Get:\|Setting up\)/   &/p'; then
      return 0
    fi
  fi
  printf 'missing (%s):%s\nOn Debian or Ubuntu: sudo apt-get install --no-install-recommends%s\n' \
    "$why" "$missing" "$missing" >&2
  return 1
}

# cached FOLDER NAME: a variable of CMake in a build folder; nothing where there is none.
cached() { sed -n "s/^$2:[A-Z]*=//p" "$1/CMakeCache.txt" 2>/dev/null || true; }
# Whether a build folder stands where CMake made it. CMake refuses one that was copied or moved.
made_here() { [[ ! -e $1/CMakeCache.txt || $(cached "$1" CMAKE_CACHEFILE_DIR) -ef $1 ]]; }
# Whether build/PRESET is of the compiler that CXX names; CMake reads CXX only once, and not where the preset has its own.
made_by_cxx() {
  local compiler=$(cached "$build/$1" CMAKE_CXX_COMPILER)
  [[ ! ${CXX:-} || ! $compiler || $(command -v ${CXX%% *}) -ef $compiler ]] ||
    cmake --preset "$1" -N | grep CMAKE_CXX_COMPILER= >/dev/null
}
# check_build_folder PRESET: of one that cannot be used, fails with the command that removes it.
check_build_folder() {
  local folder=$build/$1 made=
  made_here "$folder" || made="in $(cached "$folder" CMAKE_CACHEFILE_DIR), then copied or moved"
  [[ $made ]] || made_by_cxx "$1" || made="by $(cached "$folder" CMAKE_CXX_COMPILER), but CXX is $CXX"
  [[ ! $made ]] || fail "build/$1 was made $made. To build again, remove it: rm -rf $(printf %q "$folder")"
}

# build_preset PRESET [TARGET...]: configures and builds into build/PRESET.
build_preset() {
  local preset=$1 log=$build/$1.configure.log
  shift
  check_build_folder "$preset"
  say "configuring build/$preset"
  mkdir -p "$build"
  cmake --preset "$preset" >"$log" 2>&1 || { cat "$log" >&2; return 1; }
  say "building build/$preset"
  cmake --build "build/$preset" --parallel "$jobs" ${1:+--target "$@"}
}

# build_explorer PAGE: the explorer as one HTML file; its engine stays in build/explorer.
explorer_packages="cmake ninja-build libeigen3-dev libboost-dev emscripten nodejs python3"
build_explorer() {
  local page=$1 log=$build/explorer.configure.log
  check_build_folder explorer
  say "building the explorer"
  mkdir -p "$build" "${page%/*}"
  # Debian's emscripten finds the packages of nodejs there
  export NODE_PATH=/usr/share/nodejs${NODE_PATH:+:$NODE_PATH}
  emcmake cmake -G Ninja -S examples/explorer -B build/explorer >"$log" 2>&1 || { cat "$log" >&2; return 1; }
  cmake --build build/explorer --parallel "$jobs"
  python3 examples/explorer/assemble.py build/explorer "$page"
}

# build_python_package: into a venv of build/python; what is made on the way stays there, so that the next time is quick.
build_python_package() {
  say "building the package for Python"
  [[ -x $python ]] || /usr/bin/python3 -m venv --system-site-packages "$build/python/venv"
  # On the catalogue of the examples, if they are built. pip shows nothing of a build, or all of it
  local shared=
  [[ -f $build/examples/CMakeCache.txt ]] && shared=$build/examples
  PASSIVE_HAPTICS_CMAKE_BUILD=$shared CMAKE_BUILD_PARALLEL_LEVEL=$jobs "$python" -m pip install --verbose \
    --disable-pip-version-check --no-build-isolation --no-deps --force-reinstall examples/python 2>&1 |
    tee "$build/python/build.log" | sed --unbuffered --quiet 's/^ *\(\[[0-9]*\/[0-9]*\] \)/\1/p; /error: \|ERROR/p'
}
