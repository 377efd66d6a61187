/// @file
/// Shapes in Python that are made of another shape or of a list of corners.
#pragma once

#include <passive_haptics_python/shapes.hpp>

#include <passive_haptics/scene/shapes/complement.hpp>
#include <passive_haptics/scene/shapes/convex_polygon.hpp>
#include <passive_haptics/scene/shapes/offset.hpp>

#include <algorithm>

namespace passive_haptics_python {

namespace detail {

// The shape that a dictionary names.
inline py::object inner_shape(const py::dict& given, const std::string& name) {
  if (!given.contains("shape")) refuse_type(name + " needs a shape: " + name + "(shape, ...)");
  const py::object of = given["shape"];
  expect<shape>(of, "shape", "a shape such as half_space(...)");
  return of;
}

}  // namespace detail

/// A shape grown or shrunk.
struct offset_shape : shape {
  py::object of;                ///< The shape.
  ph::offset_parameters table;  ///< How much it grows.

  /// The names of the parameters.
  static std::vector<std::string> names() { return {"shape", "growth"}; }
  /// Of a dictionary.
  static offset_shape made(const py::dict& given, const std::string& name) {
    const py::object of = detail::inner_shape(given, name);
    const py::dict others = given.attr("copy")();
    others.attr("pop")("shape");
    ph::offset_parameters p;
    assign_members(p, others, name);
    return {py::cast<const shape&>(of).visit([&]<int D>(const any_shape<D>& s) -> shape_geometry {
              return any_shape<D>(ph::offset(s, p.growth));
            }),
            of, p};
  }
  /// All parameters.
  py::dict parameters() const {
    py::dict all;
    all["shape"] = of;
    all["growth"] = table.growth;
    return all;
  }
  /// All parameters: none has a default that makes sense.
  py::dict changed() const { return parameters(); }
};

/// A shape with wall and free space swapped.
struct complement_shape : shape {
  py::object of;  ///< The shape.

  /// The names of the parameters.
  static std::vector<std::string> names() { return {"shape"}; }
  /// Of a dictionary.
  static complement_shape made(const py::dict& given, const std::string& name) {
    const py::object of = detail::inner_shape(given, name);
    if (given.size() > 1) refuse_type(name + " has one parameter, shape");
    return {py::cast<const shape&>(of).visit([&]<int D>(const any_shape<D>& s) -> shape_geometry {
              return any_shape<D>(ph::complement(s));
            }),
            of};
  }
  /// The shape.
  py::dict parameters() const {
    py::dict all;
    all["shape"] = of;
    return all;
  }
  /// The shape.
  py::dict changed() const { return parameters(); }
};

/// A convex polygon of 3 to 8 corners.
struct polygon_shape : shape {
  static constexpr std::size_t min_corners = 3, max_corners = 8;  ///< Corners.
  std::vector<ph::point<2>> corners;                              ///< [m]

  /// The names of the parameters.
  static std::vector<std::string> names() { return {"corners"}; }
  /// Of a dictionary.
  static polygon_shape made(const py::dict& given, const std::string& name) {
    const bool is_list = given.contains("corners") && PySequence_Check(py::object(given["corners"]).ptr());
    const std::size_t size = is_list ? py::len(given["corners"]) : 0;
    if (size < min_corners || size > max_corners)
      refuse_value("number of corners of " + name + " = " + std::to_string(size) + ", expected 3 to 8");
    for (const auto& [key, value] : given)
      if (!key.equal(py::str("corners")))
        refuse_type(name + " has no parameter " + std::string(py::repr(key)) + ", expected corners");
    const auto list = py::reinterpret_borrow<py::sequence>(given["corners"]);
    std::vector<ph::point<2>> corners;
    for (std::size_t i = 0; i < size; ++i)
      corners.emplace_back(vector_from<2>(py::object(list[i]), "corners[" + std::to_string(i) + "]"));
    return made_of<min_corners>(corners);
  }
  /// The corners.
  py::dict parameters() const {
    py::dict all;
    all["corners"] = to_python(corners, {"corners", "m", ph::range::finite});
    return all;
  }
  /// The corners.
  py::dict changed() const { return parameters(); }

 private:
  template <std::size_t K>
  static polygon_shape made_of(const std::vector<ph::point<2>>& corners) {
    if constexpr (K < max_corners) {
      if (corners.size() != K) return made_of<K + 1>(corners);
    }
    ph::convex_polygon_parameters<int(K)> p;
    std::copy_n(corners.begin(), K, p.corners.begin());
    return {shape_geometry(any_shape<2>(ph::convex_polygon<int(K)>(p))), corners};
  }
};

}  // namespace passive_haptics_python
