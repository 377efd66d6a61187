#include "fields.hpp"

#include "json.hpp"

#include <algorithm>

namespace explorer {
namespace {

// The name without underscores.
std::string label_of(std::string_view name) {
  std::string label(name);
  std::replace(label.begin(), label.end(), '_', ' ');
  return label;
}

}  // namespace

const field* find(const field_list& all, std::string_view name) {
  for (const field& f : all)
    if (f.name == name) return &f;
  return nullptr;
}

std::string text_of(const field& f) {
  if (f.text != nullptr) return *f.text;
  if (f.choice != nullptr)
    return std::string(ph::choices_of(f.about).at(static_cast<std::size_t>(f.get_choice(f.choice))));
  std::string text;
  for (int i = 0; i < f.count; ++i) text.append(i == 0 ? "" : ",").append(number_text(f.numbers[i]));
  return text;
}

void read(const field& f, const std::string& text) {
  if (f.text != nullptr) {
    *f.text = text;
  } else if (f.choice != nullptr) {
    const auto words = ph::choices_of(f.about);
    const auto word = std::find(words.begin(), words.end(), text);
    if (word == words.end()) refuse(f.name, text, std::string("one of ") + f.about.choices);
    f.set_choice(f.choice, static_cast<int>(word - words.begin()));
  } else {
    const auto found = numbers_of(f.name, text);
    if (found.size() != static_cast<std::size_t>(f.count))
      refuse(f.name, text,
             f.count == 1 ? "a number" : std::to_string(f.count) + " numbers with commas between");
    std::copy(found.begin(), found.end(), f.numbers);
  }
}

void read(const field_list& all, const settings& given) {
  for (const field& f : all)
    if (const std::string* text = given.find(f.name)) read(f, *text);
}

std::string form_of(const field_list& now, const field_list& usual) {
  json_writer json;
  json.list([&] {
    for (std::size_t k = 0; k < now.size(); ++k) {
      const field& f = now[k];
      json.object([&] {
        json.put("name", f.name);
        json.put("group", f.group);
        json.put("label", label_of(f.about.name));
        json.put("unit", f.about.unit);
        json.put("value", text_of(f));
        json.put("default", text_of(usual[k]));
        json.put("size", f.count);
        if (f.choice != nullptr) {
          json.put("kind", "choice");
          json.put("expected", std::string("one of ") + f.about.choices);
          json.put_list("choices", ph::choices_of(f.about));
        } else if (f.text != nullptr) {
          json.put("kind", "text");
          json.put("expected", "a text as of the catalogue's scenes");
        } else {
          json.put("kind", f.name == "brakes.present" ? "bool" : "number");
          json.put("expected", to_text(f.about.hard));
        }
      });
    }
  });
  return json.text();
}

}  // namespace explorer
