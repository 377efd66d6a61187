/// @file
/// Settings by name: one code reads, writes and describes all parameters.
#pragma once

#include "settings.hpp"

#include <passive_haptics/runtime/any_parameters.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace explorer {

namespace runtime = passive_haptics::runtime;

/// A member of a table of parameters: numbers, an enumeration or a text, by address.
struct field : runtime::field {
  std::string name;   ///< As in the settings: "mechanism.length_1".
  const char* group;  ///< Its part of the form.
};

/// Fields, in the order of a form.
using field_list = std::vector<field>;

/// Adds these members, with `prefix` before their names.
inline void add_fields(field_list& all, const runtime::field_list& members, const std::string& prefix,
                       const char* group) {
  for (const runtime::field& f : members) all.push_back({f, prefix + f.about.name, group});
}
/// Adds the members of a table, which must outlive the list.
inline void add_fields(field_list& all, runtime::any_parameters& table, const std::string& prefix,
                       const char* group) {
  add_fields(all, table.fields(), prefix, group);
}
/// The same for a struct of parameters.
template <ph::Parameters P>
void add_fields(field_list& all, P& table, const std::string& prefix, const char* group) {
  runtime::field_list members;
  runtime::add_fields(members, table);
  add_fields(all, members, prefix, group);
}

/// The field of a name, or nullptr.
const field* find(const field_list& all, std::string_view name);
/// The value as text that read() reads back to the last bit.
std::string text_of(const field& f);
/// Sets all fields that the settings name. Throws std::invalid_argument.
void read(const field_list& all, const settings& given);
/// The list of explorer_form(), JSON; `usual` has the defaults in the same order.
std::string form_of(const field_list& now, const field_list& usual);

}  // namespace explorer
