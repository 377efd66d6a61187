/// @file
/// A device, its law, scene and state as one text, *settings*: lines "NAME=VALUE". A link and a preset are
/// such a text, too. Numbers of a vector have commas between: "q=0.785,1.571". Unnamed settings have their
/// defaults.
///
///     mechanism=tendon_two_link      an id of the catalogue
///     law=direct_control             an id of the catalogue
///     mechanism.length_1=0.15        a member of the mechanism's table
///     brakes.torque_limit=1,1        a member of the table of the brakes, one for each or one for all
///     brakes.present=1,0             joints that have brakes
///     law.margin=0.2                 a member of the table of the law
///     options.max_approximation_angle=1.55
///     scene=plane:0,0.225,0,-1       none, plane:POINT,NORMAL, solid:CENTRE,RADIUS, hollow:CENTRE,RADIUS,
///                                    outline:X,Y,X,Y,... (in the plane: a polygon, free outside)
///     scene.stiffness=1e7            [N/m]
///     scene.rate=20                  updates of the environment [Hz]; 0: each cycle
///     hand=pointer                   pointer, or along: a hand by itself that moves along the wall
///     hand.stiffness=300             of the spring between pointer and handle, and so on
///     desired=scene                  scene, or given: F_d is the state's, as of a wall behind the handle
///     q=..., qd=..., Fh=..., Fd=...  the state; q and qd [rad or m], forces [N]
///     alpha=0.5                      the scale factor of a pose instead of the law's; -1: that of the law
#pragma once

#include <log/number_text.hpp>

#include <passive_haptics/core/parameter_text.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace explorer {

namespace ph = passive_haptics;

/// A text of lines NAME=VALUE, in which each name stands once: the last line counts.
class settings {
 public:
  /// None.
  settings() = default;
  /// From a text; empty lines and lines that begin with # are skipped. Throws std::invalid_argument.
  explicit settings(std::string_view text);

  /// The value, or nullptr.
  const std::string* find(std::string_view name) const;
  /// Sets a value.
  void set(std::string_view name, std::string_view value);
  /// All lines.
  std::string text() const;
  /// Names and values.
  const std::vector<std::pair<std::string, std::string>>& lines() const { return lines_; }

 private:
  std::vector<std::pair<std::string, std::string>> lines_;
};

/// The shortest text of a number.
std::string number_text(double value);
/// "name = found: expected ...", thrown as std::invalid_argument.
[[noreturn]] void refuse(std::string_view name, std::string_view found, std::string_view expected);
/// "one of A, B", of the names of the elements of a list.
template <class Elements, class Name>
std::string names_of(const Elements& all, Name name) {
  std::string text = "one of ";
  for (const auto& one : all) text.append(&one == &all.front() ? "" : ", ").append(name(one));
  return text;
}
/// The numbers between commas. Throws std::invalid_argument with the name.
std::vector<double> numbers_of(std::string_view name, std::string_view text);

}  // namespace explorer
