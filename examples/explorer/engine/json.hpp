/// @file
/// A writer of JSON.
#pragma once

#include <log/number_text.hpp>

#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>

namespace explorer {

/// Text of one JSON value, written from left to right: `json.object([&] { json.put("id", "gamma"); })`.
class json_writer {
 public:
  /// What was written.
  const std::string& text() const { return text_; }

  /// {...}: f writes the members.
  template <class F>
  void object(F&& f) {
    enclose('{', '}', f);
  }
  /// [...]: f writes the elements.
  template <class F>
  void list(F&& f) {
    enclose('[', ']', f);
  }
  /// "name": before the value of a member.
  void name(std::string_view member) {
    value(member);
    text_ += ':';
    is_first_ = true;
  }
  /// A text.
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
  /// A text, not a bool.
  void value(const char* text) { value(std::string_view(text)); }
  /// A number; null where it is not finite.
  void value(double number) {
    separate();
    std::string digits = "null";
    if (std::isfinite(number)) example::set_to_number(digits, number);
    text_ += digits;
  }
  /// A whole number.
  void value(int number) { value(static_cast<double>(number)); }
  /// A member.
  template <class V>
  void put(std::string_view member, const V& v) {
    name(member);
    value(v);
  }
  /// A member that is a list of texts or numbers.
  template <class Values>
  void put_list(std::string_view member, const Values& values) {
    name(member);
    list([&] {
      for (const auto& v : values) value(v);
    });
  }

 private:
  void separate() {
    if (!is_first_) text_ += ',';
    is_first_ = false;
  }
  template <class F>
  void enclose(char open, char close, F& f) {
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
