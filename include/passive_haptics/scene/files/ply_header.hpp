/// The header of a PLY file.
#pragma once

#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/scene/files/mesh_source.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace passive_haptics::detail {

/// Types of values, each with two names in files.
enum class ply_type { none, int8, uint8, int16, uint16, int32, uint32, float32, float64 };

inline ply_type ply_type_of(std::string_view word) {
  constexpr std::array<std::string_view, 9> old{"",    "char", "uchar", "short", "ushort",
                                                "int", "uint", "float", "double"};
  constexpr std::array<std::string_view, 9> sized{"",      "int8",   "uint8",   "int16",  "uint16",
                                                  "int32", "uint32", "float32", "float64"};
  std::size_t i = old.size() - 1;
  while (i > 0 && !is_keyword(word, old[i]) && !is_keyword(word, sized[i])) --i;
  return static_cast<ply_type>(i);
}

inline bool is_whole(ply_type t) { return t != ply_type::float32 && t != ply_type::float64; }

inline std::size_t size_of(ply_type t) {
  constexpr std::array<std::size_t, 9> bytes{0, 1, 1, 2, 2, 4, 4, 4, 8};
  return nth(bytes, t);
}

template <class Named>
const Named* find_named(const std::vector<Named>& all, std::string_view name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Named& x) { return x.name == name; });
  return found == all.end() ? nullptr : &*found;
}

/// A value, or a list of values after their number.
struct ply_property {
  std::string name;
  ply_type type = ply_type::none;
  ply_type count = ply_type::none;  ///< Type of a list's length.

  bool is_list() const { return count != ply_type::none; }
};

struct ply_element {
  std::string name;
  std::size_t rows = 0;
  std::vector<ply_property> properties;

  const ply_property* find(std::string_view property) const { return find_named(properties, property); }
  /// Minimum size of a row [bytes].
  std::size_t min_row_size(bool is_text) const {
    std::size_t least = 0;
    for (const ply_property& p : properties)  // in a text a digit and a separator
      least += is_text ? 2 : size_of(p.is_list() ? p.count : p.type);
    return least;
  }
};

struct ply_header {
  bool is_text = false;
  std::endian order = std::endian::little;
  std::vector<ply_element> elements;

  const ply_element* find(std::string_view element) const { return find_named(elements, element); }
};

/// A name as the reader compares it: known names in lower case.
inline std::string ply_name(std::string_view word) {
  constexpr std::array<std::string_view, 9> known{"vertex", "face", "edge",           "tristrips",   "x",
                                                  "y",      "z",    "vertex_indices", "vertex_index"};
  const auto found =
      std::find_if(known.begin(), known.end(), [&](std::string_view k) { return is_keyword(word, k); });
  return std::string(found == known.end() ? word : *found);
}

inline ply_property read_ply_property(mesh_source& from) {
  constexpr const char* types = "a type: char, uchar, short, ushort, int, uint, float or double";
  const auto type_of = [&](std::string_view word) {
    if (ply_type_of(word) == ply_type::none) from.fail(word, types);
    return ply_type_of(word);
  };
  ply_property p;
  std::string_view word = from.word_in_line();
  if (is_keyword(word, "list")) {
    word = from.word_in_line();
    p.count = type_of(word);
    if (!is_whole(p.count)) from.fail(word, "a type of whole numbers");
    word = from.word_in_line();
  }
  p.type = type_of(word);
  p.name = ply_name(from.word_in_line());
  if (p.name.empty()) from.fail({}, "the name of a property");
  return p;
}

inline ply_element read_ply_element(mesh_source& from) {
  ply_element e;
  e.name = ply_name(from.word_in_line());
  if (e.name.empty()) from.fail({}, "the name of an element");
  e.rows = from.number<std::size_t>(from.word_in_line(), "how many rows there are");
  return e;
}

inline void read_ply_format(mesh_source& from, ply_header& header) {
  const std::string_view format = from.word_in_line();
  header.is_text = is_keyword(format, "ascii");
  const bool is_big = is_keyword(format, "binary_big_endian");
  header.order = is_big ? std::endian::big : std::endian::little;
  if (!header.is_text && !is_big && !is_keyword(format, "binary_little_endian"))
    from.fail(format, "ascii, binary_little_endian or binary_big_endian");
  if (const auto version = from.word_in_line(); version != "1.0") from.fail(version, "version 1.0");
}

/// Reads to the end of the line "end_header". Skips unknown lines before the first element.
inline ply_header read_ply_header(mesh_source& from, polygons& to) {
  ply_header header;
  constexpr std::string_view end = "end_header";
  const auto end_line = [&] {
    if (const auto word = from.word_in_line(); !word.empty()) from.fail(word, "the end of the line");
    if (from.lines().is_last()) from.fail({}, "'end_header' and the data; the file was cut off");
    from.next_line();
  };
  const auto next = [&] {  // the first word of the next line that is no comment
    for (;;) {
      end_line();
      const auto word = from.word_in_line();
      const bool is_comment = is_keyword(word, "comment") || is_keyword(word, "obj_info");
      if (!word.empty() && !is_comment) return word;
      while (!from.word_in_line().empty()) {
      }
    }
  };
  std::string_view word = from.word_in_line();
  if (!is_keyword(word, "ply")) from.fail(word, "'ply'");
  word = next();
  if (!is_keyword(word, "format")) from.fail(word, "'format'");
  read_ply_format(from, header);
  for (word = next(); !is_keyword(word, end); word = next()) {
    if (is_keyword(word, "element")) {
      ply_element e = read_ply_element(from);
      if (header.find(e.name) != nullptr) from.fail(e.name, "an element of another name");
      header.elements.push_back(std::move(e));
    } else if (is_keyword(word, "property") && !header.elements.empty()) {
      ply_property p = read_ply_property(from);
      ply_element& of = header.elements.back();
      if (of.find(p.name) != nullptr) from.fail(p.name, "a property of another name");
      of.properties.push_back(std::move(p));
    } else if (header.elements.empty() && !is_keyword(word, "property")) {
      to.skip_line(from.place_of(word));
      while (!from.word_in_line().empty()) {
      }
    } else {
      from.fail(word, "element, property, comment, obj_info or end_header");
    }
  }
  end_line();
  return header;
}

}  // namespace passive_haptics::detail
