#include <configuration/toml_section.hpp>

#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <sstream>
#include <stdexcept>

namespace example {
namespace {

// Whether an error "NAME = VALUE, expected WHAT" has this key as a word of its NAME.
bool speaks_of(std::string_view error, std::string_view key) {
  const auto in_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  const std::string_view name = error.substr(0, error.find(" = "));
  for (auto at = name.find(key); at != std::string_view::npos; at = name.find(key, at + 1)) {
    const auto end = at + key.size();
    if ((at == 0 || !in_word(name[at - 1])) && (end == name.size() || !in_word(name[end]))) return true;
  }
  return false;
}

}  // namespace

struct toml_section::state {
  std::string file, name;  // name: "brakes" or "wall[1]"
  std::shared_ptr<const toml::table> root;
  const toml::table* table = nullptr;  // within root; none if the section is not there
  std::set<std::string, std::less<>> known;
  std::vector<std::shared_ptr<state>> inner;

  [[noreturn]] void fail(const toml::node* at, const std::string& text) const {
    std::ostringstream message;
    message << file;
    if (at != nullptr && at->source().begin.line > 0) message << ':' << at->source().begin.line;
    message << ": " << text;
    throw std::invalid_argument(message.str());
  }
  std::string named(std::string_view key) const {
    return name.empty() ? std::string(key) : std::string(name).append(".").append(key);
  }
  [[noreturn]] void expected(std::string_view key, const toml::node& at, const std::string& what) const {
    std::ostringstream value;
    if (at.is_table()) value << "a table";
    else at.visit([&](const auto& node) { value << node; });
    fail(&at, named(key).append(" = ").append(value.str()).append(", expected ").append(what));
  }
  const toml::node* find(std::string_view key) {
    known.emplace(key);
    return table == nullptr ? nullptr : table->get(key);
  }
  std::shared_ptr<state> within(std::string inner_name, const toml::table* inner_table) {
    auto s = std::make_shared<state>();
    s->file = file;
    s->name = std::move(inner_name);
    s->root = root;
    s->table = inner_table;
    inner.push_back(s);
    return s;
  }
};

toml_section::toml_section(std::shared_ptr<state> s) : state_(std::move(s)) {}

toml_section toml_section::nothing() {
  auto s = std::make_shared<state>();
  s->file = "built-in configuration";
  return toml_section(std::move(s));
}

toml_section toml_section::file(const std::string& path) {
  auto s = std::make_shared<state>();
  s->file = path;
  if (std::filesystem::is_directory(path)) s->fail(nullptr, "is a directory, expected a file");
  if (!std::filesystem::exists(path)) s->fail(nullptr, "no such file");
  try {
    s->root = std::make_shared<const toml::table>(toml::parse_file(path));
  } catch (const toml::parse_error& error) {
    std::ostringstream text;
    text << path << ':' << error.source().begin.line << ": " << error.description();
    throw std::invalid_argument(text.str());
  }
  s->table = s->root.get();
  return toml_section(std::move(s));
}

template <class T>
void toml_section::read_each(std::string_view key, T* values, std::size_t count, const char* kinds,
                             const char* kind, std::string_view meaning) {
  const toml::node* node = state_->find(key);
  if (node == nullptr) return;
  const auto as = [](const toml::node& n, T& to) {
    if constexpr (std::is_same_v<T, double>) {
      if (!n.is_number()) return false;
      to = *n.value<double>();
    } else {
      const auto found = n.value_exact<std::conditional_t<std::is_same_v<T, bool>, bool, std::int64_t>>();
      if (!found || !std::in_range<int>(static_cast<std::int64_t>(*found))) return false;
      to = static_cast<T>(*found);
    }
    return true;
  };
  std::ostringstream what;
  if (count == 1) what << kind;
  else what << count << ' ' << kinds << ", or one for all";
  what << meaning;
  if (const toml::array* list = node->as_array()) {
    if (list->size() != count) state_->expected(key, *node, what.str());
    for (std::size_t i = 0; i < count; ++i)
      if (!as((*list)[i], values[i])) state_->expected(key, *node, what.str());
  } else {
    T one{};
    if (!as(*node, one)) state_->expected(key, *node, what.str());
    std::fill_n(values, count, one);
  }
}

void toml_section::read(std::string_view key, double* values, std::size_t count, std::string_view meaning) {
  read_each(key, values, count, "numbers", "a number", meaning);
}
void toml_section::read(std::string_view key, int* values, std::size_t count, std::string_view meaning) {
  read_each(key, values, count, "whole numbers", "a whole number", meaning);
}
void toml_section::read(std::string_view key, bool* values, std::size_t count, std::string_view meaning) {
  read_each(key, values, count, "times true or false", "true or false", meaning);
}
void toml_section::read(std::string_view key, double& value, std::string_view meaning) {
  read(key, &value, 1, meaning);
}
void toml_section::read(std::string_view key, int& value, std::string_view meaning) {
  read(key, &value, 1, meaning);
}
void toml_section::read(std::string_view key, bool& value, std::string_view meaning) {
  read(key, &value, 1, meaning);
}

std::string toml_section::meaning_of(const passive_haptics::member_description& described) {
  std::string text;
  if (described.hard.is_checked) text.append(": ").append(to_text(described.hard));
  if (*described.unit != '\0') text.append(" [").append(described.unit).append("]");
  return text;
}

void toml_section::read(std::string_view key, std::string& value) {
  const toml::node* node = state_->find(key);
  if (node == nullptr) return;
  const auto text = node->value_exact<std::string>();
  if (!text) state_->expected(key, *node, "a text in quotes");
  value = *text;
}

void toml_section::read(std::string_view key, std::string& value,
                        const std::vector<std::string_view>& choices) {
  read(key, value);
  if (std::find(choices.begin(), choices.end(), value) != choices.end()) return;
  std::string all;
  for (const auto choice : choices) all.append(all.empty() ? "\"" : ", \"").append(choice).append("\"");
  const toml::node* node = state_->find(key);
  if (node == nullptr)
    state_->fail(nullptr, state_->named(key).append(" is missing, expected one of ").append(all));
  state_->expected(key, *node, std::string("one of ").append(all));
}

std::size_t toml_section::read_pairs(std::string_view key, double* values, std::size_t most) {
  const toml::node* node = state_->find(key);
  if (node == nullptr) return 0;
  std::ostringstream what;
  what << "pairs of numbers, at most " << most << " of them";
  const toml::array* list = node->as_array();
  if (list == nullptr || list->size() > most) state_->expected(key, *node, what.str());
  for (std::size_t i = 0; i < list->size(); ++i) {
    const toml::array* pair = (*list)[i].as_array();
    if (pair == nullptr || pair->size() != 2 || !(*pair)[0].is_number() || !(*pair)[1].is_number())
      state_->expected(key, *node, what.str());
    for (std::size_t j = 0; j < 2; ++j) values[2 * i + j] = *(*pair)[j].value<double>();
  }
  return list->size();
}

toml_section toml_section::section(std::string_view key) {
  const toml::node* node = state_->find(key);
  if (node != nullptr && !node->is_table())
    state_->expected(key, *node, "a table, [" + state_->named(key) + "]");
  return toml_section(state_->within(state_->named(key), node == nullptr ? nullptr : node->as_table()));
}

std::vector<toml_section> toml_section::sections(std::string_view key) {
  std::vector<toml_section> all;
  const toml::node* node = state_->find(key);
  if (node == nullptr) return all;
  if (!node->is_array_of_tables())
    state_->expected(key, *node, "tables, [[" + state_->named(key) + "]] each");
  for (const toml::node& one : *node->as_array()) {
    std::ostringstream name;
    name << state_->named(key) << '[' << all.size() + 1 << ']';
    all.push_back(toml_section(state_->within(name.str(), one.as_table())));
  }
  return all;
}

bool toml_section::has(std::string_view key) const {
  return state_->table != nullptr && state_->table->contains(key);
}

void toml_section::finish() const {
  if (state_->table != nullptr) {
    for (const auto& [key, node] : *state_->table) {
      if (state_->known.contains(key.str())) continue;
      std::string all;
      for (const std::string& one : state_->known) all.append(all.empty() ? "" : ", ").append(one);
      state_->fail(&node, "unknown key '" + state_->named(key.str()) + "', expected one of " + all);
    }
  }
  for (const auto& inner : state_->inner) toml_section(inner).finish();
}

void toml_section::require(const std::string& error) const {
  if (error.empty()) return;
  const std::string where = state_->name.empty() ? "" : "[" + state_->name + "] ";
  // The line of the key that it speaks of, if it is one of these
  const toml::node* at = state_->table;
  std::size_t length = 0;
  if (state_->table != nullptr)
    for (const auto& [key, node] : *state_->table)
      if (key.str().size() > length && speaks_of(error, key.str())) {
        at = &node;
        length = key.str().size();
      }
  state_->fail(at, where + error);
}

}  // namespace example
