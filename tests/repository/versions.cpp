// What names a version names the one of the headers.
#include "texts.hpp"

#include <passive_haptics/core/version.hpp>

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace {

TEST(versions, are_those_of_the_headers) {
  const std::string version = std::to_string(PASSIVE_HAPTICS_VERSION_MAJOR) + "." +
                              std::to_string(PASSIVE_HAPTICS_VERSION_MINOR) + "." +
                              std::to_string(PASSIVE_HAPTICS_VERSION_PATCH);
  const std::pair<const char*, std::string> places[] = {
      {"CITATION.cff", "\nversion: " + version + "\n"},
      {"CHANGELOG.md", "\n## [" + version + "]\nThe git tag `v" + version + "`.\n"}};
  for (const auto& [file, text] : places)
    EXPECT_NE(repository::read(repository::root / file).find(text), std::string::npos)
        << file << " lacks " << text;
}

}  // namespace
