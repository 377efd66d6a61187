// slow, no sanitizers
// The run scripts as their users' surroundings are: a build folder of another place or compiler, an exported
// CDPATH. Other programs have stand-ins, so nothing is built.
#include "a_shell.hpp"

#include <string>
#include <utility>

namespace {

struct run_scripts : a_shell {
  const fs::path clone = here / "it's a clone";

  run_scripts() {
    make_clone(clone, "one");
    stand_in("dpkg", "echo Status: install ok installed");
    stand_in("ctest", "for word; do case $word in *.junit.xml) : >\"$word\" ;; esac; done");
    stand_in("cmake", "case \"$*\" in *slow*-N*) echo 'CMAKE_CXX_COMPILER=\"clang++\"' ;; esac");
    for (const char* tool : {"g++", "clang++", "ninja", "gnuplot", "pkg-config"}) stand_in(tool, "exec true");
  }

  // Its scripts alone, beside an example that is built.
  static void make_clone(const fs::path& place, const std::string& example) {
    for (const char* part : {".ci", "examples/help", "tests", "build/examples/examples"})
      fs::create_directories(place / part);
    for (const char* script : {".ci/setup.sh", "examples/run", "tests/run"})
      fs::copy_file(source + "/" + script, place / script);
    std::ofstream(place / ("examples/01_" + example + ".cpp"));
    std::ofstream(place / ("examples/help/01_" + example + ".txt"));
    const fs::path program = place / ("build/examples/examples/01_" + example);
    std::ofstream(program) << "#!/bin/sh\necho ran\n";
    fs::permissions(program, fs::perms::owner_all);
  }

  // As CMake leaves it.
  void cache(const std::string& preset, const fs::path& made_in, const std::string& compiler) const {
    fs::create_directories(clone / "build" / preset);
    std::ofstream(clone / "build" / preset / "CMakeCache.txt")
        << "CMAKE_CACHEFILE_DIR:INTERNAL=" << made_in.string()
        << "\nCMAKE_CXX_COMPILER:FILEPATH=" << (here / "bin" / compiler).string() << "\n";
  }
  fs::path built(const std::string& preset) const { return clone / "build" / preset; }

  outcome run(const std::string& script, const std::string& variables = "") const {
    return shell("unset CXX; " + variables + " " + on_path() + quoted(clone) + "/" + script);
  }
};

TEST_F(run_scripts, name_the_command_that_removes_a_build_folder_which_was_moved) {
  for (const auto& [script, preset] : {std::pair{"examples/run one", "examples"}, {"tests/run", "debug"}}) {
    cache(preset, "/moved/from/here", "g++");
    const outcome refused = run(script);
    EXPECT_EQ(refused.status, 1);
    const std::string say = std::string("error: build/") + preset +
                            " was made in /moved/from/here, then copied or moved. "
                            "To build again, remove it: ";
    const std::size_t at = refused.err.find(say);
    ASSERT_NE(at, std::string::npos) << refused.err;
    const std::string rest = refused.err.substr(at + say.size());
    EXPECT_EQ(shell(rest.substr(0, rest.find('\n'))).status, 0);
    EXPECT_FALSE(fs::exists(built(preset)));
  }
  EXPECT_EQ(run("tests/run").status, 0);
}

TEST_F(run_scripts, name_the_command_that_removes_a_build_folder_of_another_compiler) {
  cache("examples", built("examples"), "g++");
  for (const char* same : {"", "CXX=g++", "CXX='g++ -m32'"}) {
    const outcome o = run("examples/run one", same);
    EXPECT_EQ(o.status, 0) << same << o.err;
    EXPECT_EQ(o.out, "ran\n") << same;
  }
  const outcome refused = run("examples/run one", "CXX=clang++");
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("error: build/examples was made by " + (here / "bin/g++").string() +
                             ", but CXX is clang++. To build again, remove it: rm -rf "),
            std::string::npos)
      << refused.err;
  // Where the preset names its compiler, CXX does not count
  cache("slow", built("slow"), "clang++");
  EXPECT_EQ(run("tests/run slow", "CXX=g++").status, 0);
}

TEST_F(run_scripts, look_for_packages_anew_where_the_build_folder_was_moved) {
  stand_in("dpkg", "exit 1");  // not Debian
  stand_in("apt-get", "exit 1");
  stand_in("cmake", "case $1 in -S) ! [ -e \"$4/CMakeCache.txt\" ] ;; esac");  // refuses it
  for (const char* package : {"Eigen3", "Boost", "CLI11"})
    cache(std::string("probe/") + package + "/build", "/moved", "g++");
  EXPECT_EQ(run("examples/run one").out, "ran\n");
}

TEST_F(run_scripts, wait_while_another_process_holds_a_lock_of_apt) {
  stand_in("dpkg", "exit 1");
  stand_in("cmake", "case $1 in -S) exit 1 ;; esac");  // finds no package
  stand_in("sudo", "shift; exec \"$@\"");
  stand_in("sleep", "");
  stand_in("apt-get",
           "echo $1 >>" + quoted(here / "calls") + "; [ -e " + quoted(here) + "/$1 ] || { touch " +
               quoted(here) +
               "/$1; echo 'E: Could not get lock. It is held by process 7 (apt)' >&2; exit 100; }");
  const outcome o = run("examples/run one");
  EXPECT_EQ(o.out.substr(o.out.rfind('\n', o.out.size() - 2) + 1), "ran\n");
  EXPECT_EQ(o.err.find("missing"), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("held by process 7"), std::string::npos) << o.err;
  EXPECT_EQ(text_of(here / "calls"), "update\nupdate\ninstall\ninstall\n");
}

TEST_F(run_scripts, go_to_their_own_folder_whatever_CDPATH_is) {
  make_clone(here / "elsewhere", "other");
  const outcome o = shell("cd " + quoted(clone) + " && CDPATH=../elsewhere examples/run list");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_EQ(o.out, "one\nexplorer\npython\n");
}

}  // namespace
