#include "settings.hpp"

#include <passive_haptics/scene/files/text_lines.hpp>

namespace explorer {

settings::settings(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty() || line.front() == '#') continue;
    const std::size_t equals = line.find('=');
    if (equals == line.npos || equals == 0) refuse("setting", line, "NAME=VALUE");
    set(line.substr(0, equals), line.substr(equals + 1));
  }
}

const std::string* settings::find(std::string_view name) const {
  for (const auto& [known, value] : lines_)
    if (known == name) return &value;
  return nullptr;
}

void settings::set(std::string_view name, std::string_view value) {
  for (auto& [known, old] : lines_)
    if (known == name) {
      old = value;
      return;
    }
  lines_.emplace_back(name, value);
}

std::string settings::text() const {
  std::string all;
  for (const auto& [name, value] : lines_) all.append(name).append("=").append(value).append("\n");
  return all;
}

std::string number_text(double value) {
  std::string text;
  example::set_to_number(text, value);
  return text;
}

void refuse(std::string_view name, std::string_view found, std::string_view expected) {
  constexpr std::size_t max_length = 80;
  std::string text = ph::detail::printable(found.substr(0, max_length));
  throw std::invalid_argument(
      std::string(name).append(" = '").append(text).append("': expected ").append(expected));
}

std::vector<double> numbers_of(std::string_view name, std::string_view text) {
  std::vector<double> all;
  while (true) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const std::string_view word = text.substr(0, comma);
    const auto [stop, error] = ph::detail::read_number(word, all.emplace_back());
    if (error != std::errc() || stop != word.data() + word.size()) refuse(name, word, "a number");
    if (comma == text.size()) return all;
    text.remove_prefix(comma + 1);
  }
}

}  // namespace explorer
