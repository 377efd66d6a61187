/// @file
/// A writer of JSON.
#pragma once

#include <log/number_text.hpp>

#include <string>
#include <string_view>

namespace explorer {

/// Text of one JSON value, written from left to right: `json.object([&] { json.put("id", "gamma"); })`.
class json_writer {
 public:
  /// The text so far.
  const std::string& text() const { return text_; }

  /// {...}: f writes the members.
  template <class F>
  void object(F&& f) {
    enclose('{', '}', f);
  }
  /// A list of objects: f(element) writes the members of each.
  template <class Elements, class F>
  void list(const Elements& elements, F&& f) {
    enclose('[', ']', [&] {
      for (const auto& element : elements) object([&] { f(element); });
    });
  }
  /// "name": before the value of a member.
  void name(std::string_view member) {
    value(member);
    text_ += ':';
    is_first_ = true;
  }
  /// A member: a text or a whole number.
  template <class V>
  void put(std::string_view member, const V& v) {
    name(member);
    value(v);
  }
  /// A member that is a list of texts or whole numbers.
  template <class Values>
  void put_list(std::string_view member, const Values& values) {
    name(member);
    enclose('[', ']', [&] {
      for (const auto& v : values) value(v);
    });
  }

 private:
  void value(std::string_view text) {
    separate();
    text_ += '"';
    for (const char c : text) {
      if (c == '"' || c == '\\') text_ += '\\';
      if (c == '\n') text_ += "\\n";
      else text_ += c;
    }
    text_ += '"';
  }
  void value(int number) {
    separate();
    text_ += std::to_string(number);
  }
  void separate() {
    if (!is_first_) text_ += ',';
    is_first_ = false;
  }
  template <class F>
  void enclose(char open, char close, F&& f) {
    separate();
    text_ += open;
    is_first_ = true;
    f();
    text_ += close;
    is_first_ = false;
  }

  std::string text_;
  bool is_first_ = true;
};

}  // namespace explorer
