// What README says that the main example prints.
#include <page_tables.hpp>
#include <shell_quotes.hpp>

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
  const auto directory =
      std::filesystem::temp_directory_path() / ("passive_haptics_pages_" + std::to_string(getpid()));
  const std::string run = example::in_shell_quotes(PASSIVE_HAPTICS_WALL_FOLLOWING) + " --output " +
                          example::in_shell_quotes(directory.string());
  std::string printed;
  {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(run.c_str(), "r"), pclose);
    ASSERT_TRUE(pipe);
    for (int c; (c = std::fgetc(pipe.get())) != EOF;) printed += static_cast<char>(c);
  }
  std::filesystem::remove_all(directory);
  const std::string table = printed.substr(0, printed.find("\n\n"));
  ASSERT_NE(table.find("velocity_direct_control"), std::string::npos) << printed;

  std::ifstream in(PASSIVE_HAPTICS_SOURCE_DIR "/README.md");
  const std::string readme{std::istreambuf_iterator<char>(in), {}};
  EXPECT_EQ(example::first_difference(table, between(readme, "```text\n", "```")), "") << table;
}

}  // namespace
