// Percentiles by nearest rank.
#include <passive_haptics/testing/support/percentile.hpp>

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace {

using passive_haptics::testing::percentile;
using passive_haptics::testing::sorted;

TEST(percentile, is_a_sample_that_no_more_than_its_share_fall_below) {
  std::vector<int> samples(1000);
  std::iota(samples.begin(), samples.end(), 1);
  EXPECT_EQ(percentile(samples, 0.5), 500);
  EXPECT_EQ(percentile(samples, 0.99), 990);
  EXPECT_EQ(percentile(samples, 0.999), 999);
  EXPECT_EQ(percentile(samples, 1.0), 1000);
  EXPECT_EQ(percentile(samples, 1e-9), 1);
}

TEST(percentile, of_few_samples_is_the_largest) {
  EXPECT_EQ(percentile(sorted(std::vector<double>{3, 1, 2}), 0.99), 3.0);
  EXPECT_EQ(percentile(sorted(std::vector<double>{3, 1, 2}), 0.5), 2.0);
  EXPECT_EQ(percentile(std::vector<double>{7}, 0.5), 7.0);
}

}  // namespace
