/// @file
/// Shapes of walls in Python, in the plane or in space.
#pragma once

#include <passive_haptics_python/any_shape.hpp>
#include <passive_haptics_python/values.hpp>

#include <variant>

namespace passive_haptics_python {

/// A shape of the plane or of space.
using shape_geometry = std::variant<any_shape<2>, any_shape<3>>;

/// The base class of all shapes.
struct shape {
  shape_geometry geometry;  ///< The shape.

  /// d
  int dimension() const { return geometry.index() == 0 ? 2 : 3; }
  /// Calls f with the any_shape<2> or any_shape<3>.
  template <class F>
  auto visit(F&& f) const {
    return std::visit(std::forward<F>(f), geometry);
  }
};

/// A shape that exists in the plane and in space. The first vector that is given says which.
template <template <int> class Shape, template <int> class P>
struct shape_value : shape {
  std::variant<P<2>, P<3>> table;  ///< The parameters.

  /// Of these parameters; throws std::invalid_argument.
  template <int D>
  shape_value(const P<D>& p, std::integral_constant<int, D>) : shape{any_shape<D>(Shape<D>(p))}, table(p) {}

  /// The names of the parameters.
  static std::vector<std::string> names() { return member_names<P<2>>(); }
  /// Of a dictionary.
  static shape_value made(const py::dict& given, const std::string& name) {
    return dimension_of(given, name) == 2 ? of_dimension<2>(given, name) : of_dimension<3>(given, name);
  }
  /// All parameters.
  py::dict parameters() const {
    return std::visit([](const auto& p) { return to_dict(p); }, table);
  }
  /// Those that are not the defaults.
  py::dict changed() const {
    return std::visit([](const auto& p) { return changed_members(p, std::decay_t<decltype(p)>{}); }, table);
  }

 private:
  template <int D>
  static shape_value of_dimension(const py::dict& given, const std::string& name) {
    P<D> p{};
    assign_members(p, given, name);
    return shape_value(p, std::integral_constant<int, D>());
  }
  static int dimension_of(const py::dict& given, const std::string& name) {
    if (const int found = first_length(given, name, "2 (in the plane) or 3 (in space)")) return found;
    refuse_type(name + " needs " + joined(names()) + ": vectors of 2 numbers in the plane, of 3 in space");
  }
};

}  // namespace passive_haptics_python
