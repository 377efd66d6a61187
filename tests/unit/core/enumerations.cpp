// Every enumerator has words of its own.
#include <passive_haptics/core/status.hpp>
#include <passive_haptics/force/classification.hpp>

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <string_view>

namespace ph = passive_haptics;

namespace {

// The enumerators count from 0: words for each, none twice, and `otherwise` beyond the last.
template <class Enum>
void expect_words(int count, std::string_view otherwise) {
  std::set<std::string> seen;
  for (int i = 0; i < count; ++i) {
    const std::string words(to_string(static_cast<Enum>(i)));
    EXPECT_NE(words, otherwise) << "enumerator " << i;
    EXPECT_FALSE(words.empty()) << "enumerator " << i;
    EXPECT_TRUE(seen.insert(words).second) << words << " stands for two enumerators";
  }
  EXPECT_EQ(to_string(static_cast<Enum>(count)), otherwise);
  EXPECT_EQ(to_string(static_cast<Enum>(-1)), otherwise);
}

TEST(enumerations, have_words_for_each_status) {
  expect_words<ph::status>(static_cast<int>(ph::status::scene_stale) + 1, "unknown status");
  EXPECT_EQ(to_string(ph::status::ok), "ok");
}

TEST(enumerations, have_words_for_each_power_class) {
  expect_words<ph::power_class>(static_cast<int>(ph::power_class::passive_2) + 1, "unknown power class");
  EXPECT_EQ(to_string(ph::power_class::passive_1), "passive I");
}

TEST(enumerations, have_words_for_each_display_class) {
  expect_words<ph::display_class>(static_cast<int>(ph::display_class::empty_cone) + 1,
                                  "unknown display class");
  EXPECT_EQ(to_string(ph::display_class::approximate), "approximate");
}

}  // namespace
