/// @file
/// Scenes that are written as a text: one wall of any shape, or a force that is given.
#pragma once

#include <passive_haptics/runtime/any_shape.hpp>
#include <passive_haptics/scene/contacts.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/scene.hpp>
#include <passive_haptics/scene/wall.hpp>

#include <optional>
#include <string>
#include <vector>

namespace explorer {

namespace ph = passive_haptics;
using passive_haptics::runtime::any_shape;

/// The shape of a text (exports.hpp); none for "none". Throws std::invalid_argument.
template <int D>
std::optional<any_shape<D>> shape_of(const std::string& text);
extern template std::optional<any_shape<2>> shape_of<2>(const std::string& text);
extern template std::optional<any_shape<3>> shape_of<3>(const std::string& text);

/// The surface inside a rectangle [m]: in the plane segments, 2 points each, in space triangles, 3 points
/// each; z is 0 in the plane.
template <int D>
std::vector<double> surface_of(const std::string& text, const ph::point<2>& low, const ph::point<2>& high);
extern template std::vector<double> surface_of<2>(const std::string&, const ph::point<2>&,
                                                  const ph::point<2>&);
extern template std::vector<double> surface_of<3>(const std::string&, const ph::point<2>&,
                                                  const ph::point<2>&);

/// One wall, or none; or a contact that demands a given force, wherever the handle is.
template <int D>
class wall_or_force {
 public:
  static constexpr int dimension = D;        ///< d
  using contacts_type = ph::contacts<D, 1>;  ///< At most one.

  /// A wall of this shape and stiffness [N/m], if there is a shape.
  wall_or_force(const std::optional<any_shape<D>>& shape, double stiffness) {
    if (shape) wall_.emplace(ph::wall(*shape, stiffness));
  }
  /// A contact that demands the force Fd [N] of a handle at x [m]; none for 0 N.
  static wall_or_force demanding(const ph::point<D>& Fd, const ph::point<D>& x) {
    constexpr double depth = 1.0 / 1024;  // [m]; a power of two, so that depth * stiffness is |Fd| exactly
    wall_or_force made(std::nullopt, 0);
    const double size = Fd.norm();
    if (size > 0) {
      ph::contact<D> c;
      c.normal = ph::direction_of(Fd);
      c.depth = depth;
      c.stiffness = size / depth;
      c.sensed_at = x;
      made.force_ = c;
    }
    return made;
  }

  /// The contact at x [m], if there is one.
  contacts_type touched_at(const ph::point<D>& x) const {
    if (wall_) return wall_->touched_at(x);
    contacts_type touched;
    if (force_) touched.push_back(*force_);
    return touched;
  }
  /// Gives the wall's contact from this distance off it on [m].
  void set_margin(double margin) {
    if (wall_) wall_->set_margin(margin);
  }

 private:
  std::optional<ph::static_scene<any_shape<D>>> wall_;
  std::optional<ph::contact<D>> force_;
};

/// The scene of all controllers here, sampled at its own rate.
template <int D>
using explorer_scene = ph::held_scene<wall_or_force<D>>;

}  // namespace explorer
