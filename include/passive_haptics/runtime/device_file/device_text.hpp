/// Text of a device file for a device.
#pragma once

#include <passive_haptics/runtime/device_file/device_description.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <array>
#include <charconv>
#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace passive_haptics::detail {

// Shortest text that reads back exactly. Always real, because TOML limits whole numbers.
inline std::string toml_number(double x) {
  std::array<char, 32> digits{};
  std::string text(digits.data(), std::to_chars(digits.begin(), digits.end(), x).ptr);
  return text.find_first_of(".en") == text.npos ? text.append(".0") : text;
}

inline std::string toml_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' || c == '\\' ? "\\" : "").append(1, c);
  return quoted.append("\"");
}

// `count` numbers at intervals of `stride`.
inline std::string toml_list(const double* numbers, std::size_t count, std::size_t stride = 1) {
  std::string list = "[";
  for (std::size_t i = 0; i < count; ++i)
    list.append(i == 0 ? "" : ", ").append(toml_number(numbers[i * stride]));
  return list.append("]");
}

inline std::string toml_value(const runtime::field& f) {
  using kind = runtime::field::kind;
  const auto rows = static_cast<std::size_t>(f.rows), columns = static_cast<std::size_t>(f.columns);
  const auto list_of_lists = [](std::size_t count, const auto& one) {
    std::string list = "[";
    for (std::size_t i = 0; i < count; ++i) list.append(i == 0 ? "" : ", ").append(one(i));
    return list.append("]");
  };
  switch (f.type) {
    case kind::text: return toml_text(f.text());
    case kind::choice: return toml_text(choices_of(f.about)[static_cast<std::size_t>(f.get(f.at))]);
    case kind::truth: return f.get(f.at) != 0 ? "true" : "false";
    case kind::whole: return std::to_string(f.get(f.at));
    case kind::points: {
      const std::size_t count = f.size(f.at);
      const double* const first = f.resize(f.at, count);
      return list_of_lists(count, [&](std::size_t i) { return toml_list(first + i * rows, rows); });
    }
    case kind::numbers:
      if (columns > 1)
        return list_of_lists(rows, [&](std::size_t i) { return toml_list(f.numbers() + i, columns, rows); });
      return rows == 1 ? toml_number(*f.numbers()) : toml_list(f.numbers(), rows);
    case kind::tables: break;  // have their own headers
  }
  return {};
}

// All keys of a section, followed by its tables.
inline void append_toml(std::string& to, const std::string& section, const runtime::field_list& fields) {
  using kind = runtime::field::kind;
  for (const runtime::field& f : fields)
    if (f.type != kind::tables) to.append(f.about.name).append(" = ").append(toml_value(f)).append("\n");
  for (const runtime::field& f : fields)
    for (const runtime::field_list& one : f.tables) {
      const std::string table = section + "." + f.about.name;
      to.append("\n[[").append(table).append("]]\n");
      append_toml(to, table, one);
    }
}

}  // namespace passive_haptics::detail

namespace passive_haptics::runtime {

/// Device file with all keys, which read_device() reads bit-identically. Mesh paths are absolute.
inline std::string device_text(device_description device) {
  std::string text;
  std::set<std::string> large;  // keys of implausible values
  const auto see = [&](const any_parameters& p) {
    p.for_each_suspicious([&](const char* key, const std::string&) { large.insert(key); });
  };
  const auto see_table = [&](const auto& p) {
    for_each_suspicious(p, [&](const member_description& m, const std::string&) { large.insert(m.name); });
  };
  const auto begin = [&](const std::string& header, const std::string& type) {
    text.append(text.empty() ? "" : "\n").append(header).append("\n");
    if (!type.empty()) text.append("type = ").append(detail::toml_text(type)).append("\n");
  };
  const auto add = [&](const std::string& section, const std::string& header, named_parameters& named) {
    begin(header, named.name);
    see(named.parameters);
    detail::append_toml(text, section, named.parameters.fields());
  };

  add("mechanism", "[mechanism]", device.mechanism);
  field_list brakes, scene, options;
  begin("[brakes]", "");
  add_fields(brakes, device.brakes);
  see_table(device.brakes);
  detail::append_toml(text, "brakes", brakes);
  for (named_parameters& model : device.brake_models) add("brakes.model", "[[brakes.model]]", model);
  begin("[law]", device.law.name);
  see(device.law.parameters);
  see_table(device.options);
  for (const field& f : device.law.parameters.fields()) options.push_back(f);
  add_fields(options, device.options);
  detail::append_toml(text, "law", options);
  for (wall_description& w : device.walls) {
    std::string section = "walls", header = "[[walls]]";
    for (named_parameters& shape : w.shapes) {
      for (const field& f : shape.parameters.fields())
        if (f.type == field::kind::text && std::string_view(f.about.name) == "file")
          f.text() = std::filesystem::absolute(f.text()).string();
      begin(header, shape.name);
      if (&shape == &w.shapes.front())
        text.append("stiffness = ").append(detail::toml_number(w.stiffness)).append("\n");
      see(shape.parameters);
      detail::append_toml(text, section, shape.parameters.fields());
      section += ".of";
      header = "[" + section + "]";
    }
    if (w.motion) {
      begin("[walls.motion]", "");
      see(*w.motion);
      detail::append_toml(text, "walls.motion", w.motion->fields());
    }
    see_table(wall(half_space<2>(half_space_parameters<2>{{0, 0}, {0, 1}}), w.stiffness));
  }
  for (named_parameters& effect : device.effects) add("effects", "[[effects]]", effect);
  begin("[scene]", "");
  add_fields(scene, device.scene);
  see_table(device.scene);
  detail::append_toml(text, "scene", scene);
  if (!device.has_force_sensor) begin("[sensor]", "none");

  std::string top;
  for (const std::string& key : large)
    top.append(top.empty() ? "allow_large = [" : ", ").append(detail::toml_text(key));
  if (!top.empty()) top.append("]\n");
  if (device.walls.empty()) top.append("walls = []\n");
  return top.append(top.empty() ? "" : "\n").append(text);
}

}  // namespace passive_haptics::runtime
