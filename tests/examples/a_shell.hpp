// A shell in a folder of its own.
#pragma once

#include <shell_quotes.hpp>

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace fs = std::filesystem;

inline const std::string source = PASSIVE_HAPTICS_SOURCE_DIR, folder = PASSIVE_HAPTICS_EXAMPLES_DIR;

inline std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct a_shell : ::testing::Test {
  struct outcome {
    int status;  // or 128 + the signal that it died of, as of a shell
    std::string out, err;
  };
  fs::path here;

  a_shell() {
    std::string name = (fs::temp_directory_path() / "examples_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no directory " + name);
    here = name;
  }
  ~a_shell() override { fs::remove_all(here); }

  static std::string quoted(const fs::path& word) { return example::in_shell_quotes(word.string()); }

  // A line of a shell that stands in `here`.
  outcome shell(const std::string& line) const {
    const int status =
        std::system(("cd " + quoted(here) + " && { " + line + "; } >out.txt 2>err.txt").c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text_of(here / "out.txt"),
            text_of(here / "err.txt")};
  }

  // A program that is this script, in the folder `bin`; on_path is what makes a shell take such first.
  void stand_in(const std::string& name, const std::string& script) const {
    const fs::path program = here / "bin" / name;
    fs::create_directory(program.parent_path());
    std::ofstream(program) << "#!/bin/sh\n" << script << "\n";
    fs::permissions(program, fs::perms::owner_all);
  }
  std::string on_path() const { return "PATH=" + quoted(here / "bin") + ":$PATH "; }
};
