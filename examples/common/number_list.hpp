/// @file
/// Numbers in command-line arguments.
#pragma once

#include <passive_haptics/scene/files/text_lines.hpp>

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace example {

/// The finite numbers in "1,2.5,-3"; `what` names them in the message of std::invalid_argument.
inline std::vector<double> numbers(std::string_view what, std::string_view text) {
  std::vector<double> values;
  for (std::string_view rest = text;;) {
    const std::size_t comma = rest.find(',');
    const std::string_view field = rest.substr(0, comma);
    double value = 0;
    const auto [stop, error] = passive_haptics::detail::read_number(field, value);
    if (error != std::errc() || stop != field.data() + field.size() || !std::isfinite(value)) {
      throw std::invalid_argument(std::string(what) + ": '" + std::string(field) + "' in '" +
                                  std::string(text) + "', expected a finite number");
    }
    values.push_back(value);
    if (comma == std::string_view::npos) return values;
    rest.remove_prefix(comma + 1);
  }
}

/// One finite number.
inline double number(std::string_view what, std::string_view text) {
  const auto values = numbers(what, text);
  if (values.size() != 1)
    throw std::invalid_argument(std::string(what) + ": '" + std::string(text) + "', expected one number");
  return values[0];
}

}  // namespace example
