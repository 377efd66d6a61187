#include <configuration/toml_section.hpp>

#include <passive_haptics/interop/files/file_bytes.hpp>

// One of toml++ 3.3 ends the program at a header like [.a], which the next line would tell as a mistake
#define TOML_ASSERT(expression) static_assert(true)
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
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

// Any whole number of TOML, the nearest double where it has over 53 bits, or any other one.
std::optional<double> number_of(const toml::node& n) {
  if (const auto whole = n.value_exact<std::int64_t>()) return static_cast<double>(*whole);
  return n.value_exact<double>();
}

// toml++ bounds how deep brackets are, but takes the tables of a.b.c apart by recursion.
void require_shallow_keys(const std::string& path, const std::string& text) {
  constexpr std::ptrdiff_t most_dots = 200;
  std::istringstream lines(text);
  int number = 1;
  for (std::string line; std::getline(lines, line); ++number)
    if (std::count(line.begin(), line.end(), '.') > most_dots)
      throw std::invalid_argument(path + ":" + std::to_string(number) + ": over " +
                                  std::to_string(most_dots) +
                                  " dots in a line, expected fewer; break it into lines");
}

}  // namespace

struct toml_section::state {
  std::string file, name;  // name: "brakes" or "wall[1]"
  std::shared_ptr<std::map<std::string, bool, std::less<>>>
      allowed;  // large values by key: whether there was one
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
    s->allowed = allowed;
    s->table = inner_table;
    inner.push_back(s);
    return s;
  }
};

toml_section::toml_section(std::shared_ptr<state> s) : state_(std::move(s)) {}

toml_section toml_section::nothing() {
  auto s = std::make_shared<state>();
  s->file = "built-in configuration";
  s->allowed = std::make_shared<std::map<std::string, bool, std::less<>>>();
  return toml_section(std::move(s));
}

toml_section toml_section::file(const std::string& path) {
  constexpr std::uintmax_t most_bytes = 1 << 20;
  toml_section whole = nothing();
  whole.state_->file = path;
  std::string text;
  if (const auto error = passive_haptics::read_file(path, text, most_bytes); !error.empty())
    whole.state_->fail(nullptr, error);
  require_shallow_keys(path, text);
  try {
    whole.state_->root = std::make_shared<const toml::table>(toml::parse(text, path));
  } catch (const toml::parse_error& error) {
    std::ostringstream message;
    message << path << ':' << error.source().begin.line << ": " << error.description();
    throw std::invalid_argument(message.str());
  }
  whole.state_->table = whole.state_->root.get();
  whole.read_allowed();
  return whole;
}

void toml_section::read_allowed() {
  const char* const key = "allow_large";
  const toml::node* node = state_->find(key);
  if (node == nullptr) return;
  const toml::array* list = node->as_array();
  if (list == nullptr) state_->expected(key, *node, "a list of keys in quotes");
  for (const toml::node& one : *list) {
    const auto name = one.value_exact<std::string>();
    if (!name) state_->expected(key, *node, "a list of keys in quotes");
    (*state_->allowed)[*name] = false;
  }
}

void toml_section::require_allowed(std::string_view key, const std::string& error) const {
  const auto name = state_->allowed->find(key);
  if (name != state_->allowed->end()) name->second = true;
  else require(std::string(error).append("; if it is meant, allow_large = [\"").append(key).append("\"]"));
}

template <class T>
void toml_section::read_each(std::string_view key, T* values, std::size_t count, const char* kinds,
                             const char* kind, std::string_view meaning) {
  const toml::node* node = state_->find(key);
  if (node == nullptr) return;
  const auto as = [](const toml::node& n, T& to) {
    if constexpr (std::is_same_v<T, double>) {
      const auto found = number_of(n);
      if (!found) return false;
      to = *found;
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
  const auto is_control = [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; };
  if (!text) state_->expected(key, *node, "a text in quotes");
  if (std::any_of(text->begin(), text->end(), is_control))
    state_->expected(key, *node, "a text without control characters");
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
    if (pair == nullptr || pair->size() != 2) state_->expected(key, *node, what.str());
    for (std::size_t j = 0; j < 2; ++j) {
      const auto number = number_of((*pair)[j]);
      if (!number) state_->expected(key, *node, what.str());
      values[2 * i + j] = *number;
    }
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
  if (!state_->name.empty()) return;
  for (const auto& [key, was_large] : *state_->allowed)
    if (!was_large)
      require("allow_large = [\"" + key + "\"], expected keys of values that are large; remove it");
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
