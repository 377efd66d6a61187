// slow, no sanitizers
// What pages say that examples print.
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

std::string printed_by(const std::string& program) {
  const auto directory =
      std::filesystem::temp_directory_path() / ("passive_haptics_pages_" + std::to_string(getpid()));
  const std::string run =
      example::in_shell_quotes(program) + " --output " + example::in_shell_quotes(directory.string());
  std::string printed;
  {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(run.c_str(), "r"), pclose);
    for (int c; pipe && (c = std::fgetc(pipe.get())) != EOF;) printed += static_cast<char>(c);
  }
  std::filesystem::remove_all(directory);
  return printed;
}

std::string page(const std::string& name) {
  std::ifstream in(PASSIVE_HAPTICS_SOURCE_DIR "/" + name);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(pages, readme_shows_what_the_main_example_prints) {
  const std::string printed = printed_by(PASSIVE_HAPTICS_WALL_FOLLOWING);
  const std::string table = printed.substr(0, printed.find("\n\n"));
  ASSERT_NE(table.find("velocity_direct_control"), std::string::npos) << printed;
  EXPECT_EQ(example::first_difference(table, between(page("README.md"), "```text\n", "```")), "") << table;
}

TEST(pages, the_guide_shows_what_design_prints) {
  const std::string table = between(printed_by(PASSIVE_HAPTICS_DESIGN), "N:\n\n", "\n\n");
  ASSERT_NE(table.find("five-bar, 4 brakes"), std::string::npos) << table;
  EXPECT_EQ(example::first_difference(table, between(page("docs/guide/design.md"), "```console\n", "```")),
            "")
      << table;
}

}  // namespace
