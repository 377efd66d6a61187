// slow, no sanitizers
// The experiments by number: parts, however they were run, are merged to what one run writes, byte for byte.
#include "a_shell.hpp"

#include <regex>
#include <string>
#include <utility>

namespace {

struct numbered : a_shell {
  outcome run(const std::string& arguments) const {
    return shell(quoted(PASSIVE_HAPTICS_NUMBERED) + " " + arguments);
  }
  std::string whole() const {
    EXPECT_EQ(run("--first 0 --last 29 --output whole").status, 0);
    return text_of(here / "whole/experiments_0_29.csv");
  }

  // A script of the guide in a folder that looks like a clone, whose parts are of 10 experiments, not 100.
  void lay_out(const std::string& script) const {
    const fs::path program = here / "build/examples/examples/07_experiments";
    fs::create_directories(program.parent_path());
    fs::create_symlink(PASSIVE_HAPTICS_NUMBERED, program);
    std::string text = text_of(source + "/docs/guide/" + script);
    for (const auto& [from, to] :
         {std::pair{R"(\}00)", "}0"}, {R"(\}99)", "}9"}, {"--last 299", "--last 29"}})
      text = std::regex_replace(text, std::regex(from), to);
    std::ofstream(here / script) << text;
  }
};

TEST_F(numbered, merges_parts_to_what_one_run_writes) {
  const std::string expected = whole();
  ASSERT_NE(expected.find("\n0, tendon, planar, 1000 Hz, no_direct_control, "), std::string::npos)
      << expected;
  ASSERT_NE(expected.find("\n29, tendon, concave, 20 Hz, velocity_direct_control, "), std::string::npos)
      << expected;
  for (const char* part :
       {"--first 0 --last 0", "--first 001 --last 010", "--first=11 --last=28", "--first 29 --last 29"})
    EXPECT_EQ(run(part + std::string(" --output parts")).status, 0) << part;
  EXPECT_EQ(text_of(here / "parts/experiments_0_0.csv"), expected.substr(0, expected.find("\n1, ") + 1));
  for (const char* files : {"parts/*.csv",
                            "parts/experiments_29_29.csv parts/experiments_1[!_]*.csv "
                            "parts/experiments_1_*.csv parts/experiments_0_0.csv"}) {
    const outcome o = run("--first 0 --last 29 --output merged --merge " + std::string(files));
    EXPECT_EQ(o.status, 0) << o.err;
    EXPECT_EQ(o.out, "table:   " + (here / "merged/experiments_0_29.csv").string() + "\n");
    EXPECT_EQ(text_of(here / "merged/experiments_0_29.csv"), expected);
    fs::remove_all(here / "merged");
  }
}

TEST_F(numbered, refuses_parts_that_are_not_each_experiment_once) {
  const std::string expected = whole();
  const auto at = [&](int number) { return expected.find("\n" + std::to_string(number) + ", ") + 1; };
  const std::string head = expected.substr(0, at(0));
  const auto file = [&](const std::string& name, const std::string& content) {
    std::ofstream(here / name, std::ios::binary) << content;
  };
  file("first", expected.substr(0, at(10)));
  file("overlapping", head + expected.substr(at(9)));
  file("without_its_end", head + expected.substr(at(10), expected.size() - at(10) - 1));
  file("without_a_head", expected.substr(at(10)));
  file("of_a_large_number", head + std::string(30, '9') + expected.substr(at(29) + 2));
  const std::string copy = ": expected a whole line of experiments; copy the file again";
  const std::string its_head =
      ": expected the head 'experiment, device, wall, environment, l...' in line 1; "
      "merge files that this program wrote";
  for (const auto& [files, message] :
       {std::pair{"first", std::string("no file has experiments 10 to 29: expected experiments 0 to 29; run "
                                       "--first 10 --last 29")},
        {"first overlapping",
         "experiment 9 is in 'first' and in 'overlapping': expected it once; leave one of "
         "them out"},
        {"first without_its_end", "'without_its_end', line 21" + copy},
        {"of_a_large_number", "'of_a_large_number', line 2" + copy},
        {"first without_a_head", "'without_a_head'" + its_head},
        {"first none", "cannot read 'none': expected a file of experiments; check its name"},
        {"first .", "cannot read '.': expected a file of experiments; check its name"}}) {
    const outcome o = run("--first 0 --last 29 --output merged --merge " + std::string(files));
    EXPECT_EQ(o.status, 1) << files;
    EXPECT_EQ(o.err, "error: " + message + "\n");
    EXPECT_TRUE(fs::is_empty(here / "merged")) << files;
  }
  EXPECT_EQ(run("--first 0 --last 8 --merge first").err,
            "error: 'first': experiment 9: expected experiments 0 to 8; leave the file out, or give another "
            "--first and --last\n");
}

TEST_F(numbered, refuses_numbers_that_are_none) {
  for (const auto& [arguments, status, message] :
       {std::tuple{
            "--first 3 --last 2", 1,
            "--first 3 with --last 2: expected a first number that is not above the last; exchange them"},
        {"--first 3", 1, "--last is missing: expected both --first and --last; add it"},
        {"--first 0 --last 1000000", 1,
         "experiments 0 to 1000000: expected a part of at most 1000000; run smaller parts and merge them"},
        {"--first -1 --last 2", 2,
         "--first: -1: expected a whole number of at most 18 digits; --help lists the options"},
        {"--first 1 --last 1000000000000000000", 2,
         "--last: 1000000000000000000: expected a whole number of at most 18 digits; --help lists the "
         "options"}}) {
    const outcome o = run(arguments);
    EXPECT_EQ(o.status, status) << arguments;
    EXPECT_EQ(o.err, std::string("error: ") + message + "\n");
  }
}

TEST_F(numbered, are_shared_out_by_GNU_parallel) {
  if (shell("command -v parallel").status != 0) GTEST_SKIP() << "GNU parallel is not installed";
  lay_out("sweeps_parallel.sh");
  for (int time = 0; time < 2; ++time) {  // again: all parts are there
    const outcome o = shell("sh sweeps_parallel.sh");
    EXPECT_EQ(o.status, 0) << o.err;
    EXPECT_EQ(text_of(here / "experiments_0_29.csv"), whole());
  }
}

TEST_F(numbered, are_shared_out_by_an_array_of_SLURM) {
  lay_out("sweeps_slurm.sh");
  EXPECT_EQ(shell("bash -n sweeps_slurm.sh").status, 0);
  std::smatch array;
  const std::string script = text_of(here / "sweeps_slurm.sh");
  ASSERT_TRUE(std::regex_search(script, array, std::regex("\n#SBATCH --array=0-([0-9])\n")));
  for (int task = 0; task <= std::stoi(array[1]); ++task) {
    const outcome o = shell("SLURM_ARRAY_TASK_ID=" + std::to_string(task) + " sh sweeps_slurm.sh");
    EXPECT_EQ(o.status, 0) << o.err;
  }
  EXPECT_EQ(run("--first 0 --last 29 --merge parts/*.csv").status, 0);
  EXPECT_EQ(text_of(here / "experiments_0_29.csv"), whole());
}

}  // namespace
