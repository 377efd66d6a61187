// slow, no sanitizers
// The examples as their users meet them: options, folders that cannot be written, help without a compiler.
#include "a_shell.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

namespace {

struct an_example : a_shell {
  outcome run(const std::string& program, const std::string& arguments) const {
    return shell(quoted(folder + "/" + program) + " " + arguments);
  }
};

TEST_F(an_example, says_what_its_help_text_says) {
  for (const char* name : {"01_one_wall", "02_passive_fme", "03_wall_following", "04_new_mechanism"}) {
    const outcome o = run(name, "--help");
    EXPECT_EQ(o.status, 0) << name;
    EXPECT_EQ(o.out, text_of(source + "/examples/help/" + name + ".txt")) << name;
  }
}

TEST_F(an_example, prints_what_readme_shows) {
  const std::string readme = text_of(source + "/README.md"), begin = "```console\n";
  const std::size_t from = readme.find(begin) + begin.size();
  std::istringstream lines(readme.substr(from, readme.find("```", from) - from));
  const outcome o = run("01_one_wall", "");
  EXPECT_EQ(o.status, 0);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count)
    EXPECT_NE(o.out.find(line + "\n"), std::string::npos) << line << "\nis not in\n" << o.out;
  EXPECT_GE(count, 2);
}

TEST_F(an_example, refuses_what_it_does_not_know_in_one_line) {
  for (const char* name : {"01_one_wall", "02_passive_fme", "03_wall_following", "04_new_mechanism"})
    for (const auto& [arguments, message] :
         {std::pair{"--outputs=there", "The following argument was not expected: --outputs=there"},
          {"there", "The following argument was not expected: there"}}) {
      const outcome o = run(name, arguments);
      EXPECT_EQ(o.status, 2) << name << " " << arguments;
      EXPECT_EQ(o.err, std::string("error: ") + message + "; --help lists the options\n");
      EXPECT_EQ(o.out, "");
    }
  EXPECT_EQ(run("02_passive_fme", "--output").err,
            "error: --output: 1 required DIR missing; --help lists the options\n");
  EXPECT_EQ(run("02_passive_fme", "--output ''").err,
            "error: --output: empty: expected a value; --help lists the options\n");
}

TEST_F(an_example, makes_its_folder_and_the_last_one_counts) {
  EXPECT_EQ(run("02_passive_fme", "--output there --output=here/and_there").status, 0);
  EXPECT_TRUE(fs::exists(here / "here/and_there/passive_fme_forces.csv"));
  EXPECT_FALSE(fs::exists(here / "there"));
}

TEST_F(an_example, draws_its_picture_in_any_folder) {
  if (shell("command -v gnuplot").status != 0) GTEST_SKIP() << "gnuplot is not installed";
  std::ofstream(here / ".gnuplot") << "set print '-'\nprint 'of every session'\n";
  for (const std::string there : {"there", "two words", "it's", "-", "-d", "$HOME", "a\"b", "back\\slash"}) {
    const outcome o = shell("HOME=$PWD CDPATH=.:/ OLDPWD=/ " + quoted(folder + "/02_passive_fme") +
                            " --output=" + quoted(there));
    EXPECT_EQ(o.status, 0) << there;
    EXPECT_NE(o.out.find("picture: "), std::string::npos) << there << ": " << o.out << o.err;
    EXPECT_EQ(text_of(here / there / "passive_fme.svg").rfind("<?xml", 0), 0U) << there;
  }
}

TEST_F(an_example, tells_of_a_folder_that_cannot_be_written) {
  fs::create_directories(here / "taken/passive_fme_outlines.csv");
  fs::create_directories(here / "taken/wall_following_no_direct_control.csv");
  for (const char* name : {"02_passive_fme", "03_wall_following"})
    for (const char* directory : {"/proc/none", "/dev/null/none", "taken"}) {
      const outcome o = run(name, std::string("--output=") + directory);
      EXPECT_EQ(o.status, 1) << name << " " << directory << o.err;
      EXPECT_EQ(o.err.rfind("error: cannot ", 0), 0U) << o.err;
      EXPECT_EQ(std::count(o.err.begin(), o.err.end(), '\n'), 1) << o.err;
    }
}

TEST_F(an_example, tells_of_a_disk_that_is_full) {
  // Files of nothing at all stand for it
  const outcome o = shell("(ulimit -f 0; " + quoted(folder + "/02_passive_fme") +
                          " --output there 2>&1 >/dev/null; echo $?) | cat");
  EXPECT_EQ(o.out.rfind("error: cannot write all of 'there/passive_fme_outlines.csv.part': ", 0), 0U)
      << o.out;
  EXPECT_EQ(o.out.substr(o.out.find('\n')), "\n1\n");
  for (const char* name : {"01_one_wall", "02_passive_fme", "03_wall_following", "04_new_mechanism"}) {
    const std::string arguments = name[1] == '2' || name[1] == '3' ? " --output there" : "";
    const outcome full = shell(quoted(folder + "/" + name) + arguments + " >/dev/full");
    EXPECT_EQ(full.status, 1) << name;
    EXPECT_EQ(full.err, "error: cannot write all of the output: No space left on device\n") << name;
  }
}

// As under `| head -1`
TEST_F(an_example, whose_output_nobody_reads_ends_with_its_own_status) {
  for (const char* name : {"01_one_wall", "02_passive_fme", "03_wall_following", "04_new_mechanism"})
    EXPECT_EQ(
        shell("(sleep 0.2; " + quoted(folder + "/" + name) + "; echo $? >status) | :; exit $(cat status)")
            .status,
        0)
        << name;
}

TEST_F(an_example, is_explained_without_a_compiler) {
  // Whoever builds or installs leaves a trace
  for (const char* tool : {"cmake", "apt-get", "ninja", "g++", "sudo"})
    stand_in(tool, "touch " + quoted(here / "trace"));
  int count = 0;
  for (const auto& one : fs::directory_iterator(source + "/examples")) {
    if (one.path().extension() != ".cpp") continue;
    const std::string stem = one.path().stem(), name = stem.substr(3);
    const std::string there = on_path() + quoted(source + "/examples/run") + " ";
    const std::string expected = text_of(source + "/examples/help/" + stem + ".txt");
    EXPECT_NE(expected.find("Usage: " + name + " [OPTIONS]"), std::string::npos) << stem;
    for (const char* help : {" --help", " --output=there -h"}) {
      const outcome o = shell(there + name + help);
      EXPECT_EQ(o.status, 0) << o.err;
      EXPECT_EQ(o.out, expected) << stem;
      EXPECT_EQ(o.err, "");
    }
    ++count;
  }
  EXPECT_GE(count, 8);
  EXPECT_FALSE(fs::exists(here / "trace"));
}

}  // namespace
