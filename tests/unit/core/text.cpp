#include <passive_haptics/core/text.hpp>

#include <gtest/gtest.h>

#include <clocale>
#include <locale>
#include <utility>

namespace ph = passive_haptics;

namespace {

struct decimal_comma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(text, of_a_number_has_in_six_digits_whatever_the_locale) {
  const std::locale before = std::locale::global(std::locale(std::locale(), new decimal_comma));
  std::setlocale(LC_ALL, "de_DE.UTF-8");  // where there is one
  using text_of = std::pair<double, const char*>;
  for (const auto& [number, text] : {text_of{-0.5, "-0.5"},
                                     {0.0, "0"},
                                     {-0.0, "0"},
                                     {8192.0, "8192"},
                                     {123456.7, "123457"},
                                     {999999.4, "999999"},
                                     {999999.6, "1e6"},
                                     {-1.25e9, "-1.25e9"},
                                     {0.0001, "0.0001"},
                                     {0.00001234567, "1.23457e-5"},
                                     {9.9999996, "10"},
                                     {0.1 + 0.2, "0.3"},
                                     {5e-324, "4.94066e-324"},
                                     {1.7976931348623157e308, "1.79769e308"}})
    EXPECT_EQ(ph::detail::number_text(number), text);
  EXPECT_EQ(ph::detail::value_text(1'000'000), "1000000");
  std::setlocale(LC_ALL, "C");
  std::locale::global(before);
}

}  // namespace
