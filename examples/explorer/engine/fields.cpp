#include "fields.hpp"

#include <algorithm>

namespace explorer {
namespace {

using kind = runtime::field::kind;

void read(const field& f, const std::string& text) {
  if (f.type == kind::text) {
    f.text() = text;
  } else if (f.type == kind::choice) {
    const auto words = ph::choices_of(f.about);
    const auto word = std::find(words.begin(), words.end(), text);
    if (word == words.end()) refuse(f.name, text, std::string("one of ") + f.about.choices);
    f.set(f.at, static_cast<int>(word - words.begin()));
  } else {
    auto found = numbers_of(f.name, text);
    const auto count = static_cast<std::size_t>(f.count());
    const std::string_view group = f.group, unit = f.about.unit;
    const bool takes_one_for_all = group == "brakes" || (group == "mechanism" && unit != "m");
    if (found.size() == 1 && takes_one_for_all) found.resize(count, found[0]);
    if (found.size() != count)
      refuse(f.name, text, count == 1 ? "a number" : std::to_string(count) + " numbers with commas between");
    std::copy(found.begin(), found.end(), f.numbers());
  }
}

}  // namespace

const field* find(const field_list& all, std::string_view name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const field& f) { return f.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::string text_of(const field& f) {
  if (f.type == kind::text) return f.text();
  if (f.type == kind::choice)
    return std::string(ph::choices_of(f.about).at(static_cast<std::size_t>(f.get(f.at))));
  std::string text;
  for (int i = 0; i < f.count(); ++i) text.append(i == 0 ? "" : ",").append(number_text(f.numbers()[i]));
  return text;
}

void read(const field_list& all, const settings& given) {
  for (const field& f : all)
    if (const std::string* text = given.find(f.name)) read(f, *text);
}

}  // namespace explorer
