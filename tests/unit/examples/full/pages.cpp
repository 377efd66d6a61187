// What the pages say that the main example prints.
#include <page_tables.hpp>

#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdio>
#include <memory>

namespace {

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t at = text.find(begin), from = at + begin.size(), to = text.find(end, from);
  return at == std::string::npos || to == std::string::npos ? std::string() : text.substr(from, to - from);
}

TEST(pages, readme_shows_what_the_main_example_prints) {
#ifdef PASSIVE_HAPTICS_WALL_FOLLOWING
  const auto directory =
      std::filesystem::temp_directory_path() / ("passive_haptics_pages_" + std::to_string(getpid()));
  const std::string run = PASSIVE_HAPTICS_WALL_FOLLOWING " --output '" + directory.string() + "'";
  std::string printed;
  {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(run.c_str(), "r"), pclose);
    ASSERT_TRUE(pipe);
    for (int c; (c = std::fgetc(pipe.get())) != EOF;) printed += static_cast<char>(c);
  }
  std::filesystem::remove_all(directory);
  const std::string table = printed.substr(0, printed.find("\n\n"));
  ASSERT_NE(table.find("velocity direct control"), std::string::npos) << printed;

  std::ifstream in(PASSIVE_HAPTICS_SOURCE_DIR "/README.md");
  const std::string readme{std::istreambuf_iterator<char>(in), {}};
  EXPECT_EQ(example::first_difference(table, between(readme, "```text\n", "```")), "") << table;
#else
  GTEST_SKIP() << "built without the examples";
#endif
}

TEST(pages, are_compared_word_by_word_and_figures_by_size) {
  using example::first_difference;
  EXPECT_EQ(first_difference("law 1.25 of 60", "law  1.30 of 60"), "");
  EXPECT_EQ(first_difference("0.011", "0.012"), "") << "one unit of the last digit";
  EXPECT_EQ(first_difference("0", "1"), "");
  EXPECT_NE(first_difference("0", "2"), "");
  EXPECT_NE(first_difference("1.25", "2.5"), "");
  EXPECT_NE(first_difference("1.25 mm", "1.25 m"), "");
  EXPECT_NE(first_difference("a b", "a"), "");
}

TEST(pages, hold_their_tables_between_marks) {
  const auto path =
      std::filesystem::temp_directory_path() / ("passive_haptics_page_" + std::to_string(getpid()) + ".md");
  std::ofstream(path) << "one\n<!-- table: a -->\n| 1.0 |\n<!-- end -->\ntwo\n";
  example::page_of_tables page(path);
  EXPECT_EQ(page.difference("a", "| 1.1 |\n"), "");
  EXPECT_NE(page.difference("a", "| 3.1 |\n"), "");
  page.replace("a", "| 3.1 |\n");
  EXPECT_EQ(page.text(), "one\n<!-- table: a -->\n\n| 3.1 |\n\n<!-- end -->\ntwo\n");
  EXPECT_THROW(page.difference("b", ""), std::runtime_error);
  EXPECT_THROW(example::page_of_tables(path.string() + ".none"), std::runtime_error);
  std::filesystem::remove(path);
}

}  // namespace
