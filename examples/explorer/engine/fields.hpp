/// @file
/// Settings by name: one code reads and writes all parameters.
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

/// Adds the members of parameters, which must outlive the list, with `prefix` before their names.
template <class P>
void add_fields(field_list& all, P& table, const std::string& prefix, const char* group) {
  runtime::field_list members;
  if constexpr (ph::Parameters<P>) runtime::add_fields(members, table);
  else members = table.fields();
  for (const runtime::field& f : members) all.push_back({f, prefix + f.about.name, group});
}

/// The field of a name, or nullptr.
const field* find(const field_list& all, std::string_view name);
/// The value as text that read() reads back to the last bit.
std::string text_of(const field& f);
/// Sets all fields that the settings name. Throws std::invalid_argument.
void read(const field_list& all, const settings& given);

}  // namespace explorer
