// What programs write is there whole or not at all, and only where a file may be.
#include <output.hpp>

#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <csignal>
#include <fstream>
#include <iterator>

namespace fs = std::filesystem;
using example::leftover;
using example::output_file;

namespace {

struct an_output_file : ::testing::Test {
  fs::path folder;

  an_output_file() {
    std::string name = (fs::temp_directory_path() / "output_file_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no directory " + name);
    folder = name;
  }
  ~an_output_file() override { fs::remove_all(folder); }

  fs::path at(const char* name) const { return folder / name; }
  static std::string text_of(const fs::path& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  static void put(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }
  static void write(const fs::path& path, const std::string& text) {
    output_file file(path);
    file.stream() << text;
    file.commit();
  }
  static std::string error_of(const fs::path& path) {
    try {
      write(path, "new");
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "none";
  }
};

TEST_F(an_output_file, has_its_name_once_it_is_whole) {
  const std::string large(300'000, 'x');
  put(at("a.csv"), "old");
  {
    output_file file(at("a.csv"));
    file.stream() << large << 12 << '\n';
    file.stream().flush();
    EXPECT_EQ(text_of(at("a.csv.part")), large + "12\n");
    EXPECT_EQ(text_of(at("a.csv")), "old");
    file.commit();
  }
  EXPECT_EQ(text_of(at("a.csv")), large + "12\n");
  EXPECT_FALSE(fs::exists(at("a.csv.part")));
}

TEST_F(an_output_file, that_is_given_up_leaves_what_was_there_and_its_part_only_if_that_is_kept) {
  put(at("a.csv"), "old");
  for (const bool kept : {false, true}) {
    {
      output_file file(at("a.csv"));
      file.stream() << "new";
      if (kept) file.keep();
    }
    EXPECT_EQ(text_of(at("a.csv")), "old");
    EXPECT_EQ(text_of(at("a.csv.part")), kept ? "new" : "");
  }
}

TEST_F(an_output_file, replaces_nothing_but_a_regular_file) {
  ASSERT_EQ(mkfifo(at("fifo").c_str(), 0600), 0);
  fs::create_directory(at("folder"));
  // Links, so that a writer that replaces them harms nothing
  fs::create_symlink("/dev/null", at("null"));
  fs::create_symlink(at("none"), at("link_to_nothing"));
  for (const auto& [name, kind] : {std::pair{"fifo", "a FIFO"},
                                   {"folder", "a directory"},
                                   {"null", "a device"},
                                   {"link_to_nothing", "a link to nothing"}}) {
    const auto before = fs::symlink_status(at(name)).type();
    EXPECT_EQ(error_of(at(name)), "cannot write '" + at(name).string() + "': it is " + kind +
                                      ": expected a regular file or a free name; choose another name");
    EXPECT_EQ(fs::symlink_status(at(name)).type(), before) << name;
    EXPECT_FALSE(fs::exists(at(name).string() + ".part")) << name;
  }
  EXPECT_NE(error_of(""), "none");
}

TEST_F(an_output_file, that_became_a_device_meanwhile_is_not_replaced) {
  output_file file(at("a.csv"));
  fs::create_symlink("/dev/null", at("a.csv"));
  EXPECT_THROW(file.commit(), std::runtime_error);
  EXPECT_TRUE(fs::is_symlink(at("a.csv")));
}

TEST_F(an_output_file, behind_a_link_is_replaced_and_the_link_stays) {
  fs::create_directory(at("folder"));
  put(at("folder/a.csv"), "old");
  fs::create_symlink("folder/a.csv", at("link"));
  write(at("link"), "new");
  EXPECT_TRUE(fs::is_symlink(at("link")));
  EXPECT_EQ(text_of(at("folder/a.csv")), "new");
}

TEST_F(an_output_file, is_written_by_one_only_who_is_named) {
  int ready[2], done[2];
  ASSERT_TRUE(pipe(ready) == 0 && pipe(done) == 0);
  const pid_t other = fork();
  char byte = 0;
  if (other == 0) {
    output_file file(at("a.csv"));
    file.stream() << "theirs";
    _exit(::write(ready[1], &byte, 1) == 1 && read(done[0], &byte, 1) == 1 ? (file.commit(), 0) : 1);
  }
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  const std::string part = at("a.csv").string() + ".part";
  EXPECT_EQ(error_of(at("a.csv")), "cannot write '" + part + "': it is there, and process " +
                                       std::to_string(other) +
                                       " writes to it; wait until that ends, or choose another name");
  ASSERT_EQ(::write(done[1], &byte, 1), 1);
  int status = -1;
  waitpid(other, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(text_of(at("a.csv")), "theirs");
}

TEST_F(an_output_file, takes_a_part_that_somebody_left_only_if_it_can_be_computed_again_and_is_no_link) {
  put(at("a.csv.part"), "theirs");
  EXPECT_EQ(error_of(at("a.csv")),
            "cannot write '" + at("a.csv").string() +
                ".part': it is there, left by a program that ended early; keep what you need of it, then "
                "remove it");
  EXPECT_EQ(text_of(at("a.csv.part")), "theirs");
  {
    output_file file(at("a.csv"), leftover::replace);
    file.stream() << "ours";
    EXPECT_THROW(output_file(at("a.csv"), leftover::refuse), std::runtime_error);
    file.commit();
  }
  EXPECT_EQ(text_of(at("a.csv")), "ours");
  fs::create_symlink("/dev/null", at("b.csv.part"));
  EXPECT_THROW(output_file(at("b.csv"), leftover::replace), std::runtime_error);
}

TEST_F(an_output_file, says_that_its_folder_is_not_there) {
  EXPECT_EQ(error_of(at("none/a.csv")),
            "cannot write '" + at("none/a.csv").string() +
                ".part': No such file or directory: expected a folder that is there and where you may write");
}

TEST_F(an_output_file, that_does_not_fit_is_told_and_leaves_what_was_there) {
  put(at("a.csv"), "old");
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit few{100'000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &few);
  {
    output_file file(at("a.csv"));
    file.stream() << std::string(99'000, 'x');
    file.stream().flush();
    EXPECT_EQ(file.error(), "");
    file.stream() << std::string(2'000, 'x');
    file.stream().flush();
    EXPECT_EQ(file.error(), "File too large");
    EXPECT_THROW(file.commit(), std::runtime_error);
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(text_of(at("a.csv")), "old");
  EXPECT_FALSE(fs::exists(at("a.csv.part")));
}

// A gnuplot of our own, first in PATH
TEST_F(an_output_file, of_a_gnuplot_that_fails_leaves_the_old_picture) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", (folder.string() + ":" + path).c_str(), 1);
  for (const char* script : {"printf whole", "printf half; exit 1"}) {
    put(at("gnuplot"), std::string("#!/bin/sh\n") + script + "\n");
    fs::permissions(at("gnuplot"), fs::perms::owner_all);
    example::draw(folder, "a", "plot x\n");
    EXPECT_EQ(text_of(at("a.svg")), "whole");
    EXPECT_FALSE(fs::exists(at("a.svg.part")));
  }
  setenv("PATH", path.c_str(), 1);
}

}  // namespace
