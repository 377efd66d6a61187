// slow
// How pages are compared with what programs print.
#include <page_tables.hpp>

#include <gtest/gtest.h>

#include <unistd.h>

namespace {

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
