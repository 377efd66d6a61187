/// @file
/// The members of tables of parameters as a list of fields: one code reads, writes and describes all of them.
#pragma once

#include "settings.hpp"

#include <passive_haptics/core/parameter_text.hpp>

#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace explorer {

/// A member of a table: numbers, an enumeration or a text, by address.
struct field {
  std::string name;                          ///< As in the settings: "mechanism.length_1".
  const char* group = "";                    ///< Where the form shows it.
  ph::member_description about;              ///< Name, unit, range and choices.
  double* numbers = nullptr;                 ///< The first number, or nullptr.
  int count = 1;                             ///< Numbers.
  void* choice = nullptr;                    ///< The enumeration, or nullptr.
  int (*get_choice)(const void*) = nullptr;  ///< Reads it.
  void (*set_choice)(void*, int) = nullptr;  ///< Writes it.
  std::string* text = nullptr;               ///< The text, or nullptr.
};

/// Fields, in the order of a form.
using field_list = std::vector<field>;

/// Adds the members of a table and of the tables within, with `prefix` before their names. The table must
/// outlive the list.
template <class P>
void add_fields(field_list& all, P& table, const std::string& prefix, const char* group) {
  ph::for_each_member(table, [&](const ph::member_description& about, auto& value) {
    using V = std::remove_cvref_t<decltype(value)>;
    if constexpr (ph::Parameters<V>) {
      add_fields(all, value, prefix + about.name + ".", group);
    } else {
      field& f = all.emplace_back();
      f.name = prefix + about.name;
      f.group = group;
      f.about = about;
      if constexpr (std::is_same_v<V, std::string>) {
        f.text = &value;
      } else if constexpr (std::is_enum_v<V>) {
        f.choice = &value;
        f.get_choice = [](const void* at) { return static_cast<int>(*static_cast<const V*>(at)); };
        f.set_choice = [](void* at, int number) { *static_cast<V*>(at) = static_cast<V>(number); };
      } else if constexpr (std::is_same_v<V, double>) {
        f.numbers = &value;
      } else {
        f.numbers = value.data();
        f.count = static_cast<int>(value.size());
      }
    }
  });
}

/// The field of a name, or nullptr.
const field* find(const field_list& all, std::string_view name);
/// The value as text that read() reads back to the last bit.
std::string text_of(const field& f);
/// Sets the value. Throws std::invalid_argument.
void read(const field& f, const std::string& text);
/// Sets all fields that the settings name. Throws std::invalid_argument.
void read(const field_list& all, const settings& given);
/// The list of explorer_form(), JSON; `usual` has the defaults in the same order.
std::string form_of(const field_list& now, const field_list& usual);

}  // namespace explorer
