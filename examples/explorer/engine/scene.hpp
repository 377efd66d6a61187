/// @file
/// The wall of a device, written as a text, and the scene of its controllers.
#pragma once

#include "places.hpp"

#include <passive_haptics/runtime/any_shape.hpp>
#include <passive_haptics/scene/contacts.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/scene.hpp>
#include <passive_haptics/scene/wall.hpp>

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace explorer {

using runtime::any_shape;

/// The shape of a text (settings.hpp), or none.
class wall_shape {
 public:
  /// In `dimension` dimensions. Throws std::invalid_argument.
  wall_shape(const std::string& text, int dimension);

  /// True unless the text is "none".
  explicit operator bool() const { return shape_.index() != 0; }
  /// Signed distance [m]; inf without a shape.
  double distance(const place& x) const;
  /// Unit vector out of the wall; 0 without a shape.
  place gradient(const place& x) const;
  /// The shape itself, or nullptr.
  template <int D>
  const any_shape<D>* shape() const {
    return std::get_if<any_shape<D>>(&shape_);
  }
  /// The surface inside a rectangle [m]: points x, y, z, in the plane segments of 2 each, in space triangles.
  std::vector<double> surface(const place& low, const place& high) const;

 private:
  std::string kind_;
  std::vector<double> numbers_;
  std::variant<std::monostate, any_shape<2>, any_shape<3>> shape_;
};

/// One wall, or none; or a contact that demands a given force, wherever the handle is.
template <int D>
class wall_or_force {
 public:
  static constexpr int dimension = D;        ///< d
  using contacts_type = ph::contacts<D, 1>;  ///< At most one.

  /// No wall.
  wall_or_force() = default;
  /// A wall of this shape and stiffness [N/m].
  wall_or_force(const any_shape<D>& shape, double stiffness) : wall_(ph::wall(shape, stiffness)) {}
  /// This contact.
  explicit wall_or_force(const ph::contact<D>& demanding) { force_.push_back(demanding); }

  /// The contact at x [m], if there is one.
  contacts_type touched_at(const ph::point<D>& x) const { return wall_ ? wall_->touched_at(x) : force_; }
  /// Gives the wall's contact from this distance off it on [m].
  void set_margin(double margin) {
    if (wall_) wall_->set_margin(margin);
  }

 private:
  std::optional<ph::static_scene<any_shape<D>>> wall_;
  contacts_type force_;
};

/// The scene of all controllers here, sampled at its own rate.
template <int D>
using page_scene = ph::held_scene<wall_or_force<D>>;

/// The parts of a scene.
struct scene_source {
  static constexpr double given_depth = 1.0 / 1024;  ///< [m]; a power of two: depth * stiffness is |Fd|.

  const wall_shape* wall;    ///< In the settings.
  double stiffness;          ///< Its stiffness [N/m].
  double rate;               ///< Samples a second [Hz]; 0: each cycle.
  bool is_given = false;     ///< The contact demands Fd instead.
  place Fd = place::Zero();  ///< [N]
  place at = place::Zero();  ///< The handle [m].

  /// The scene in D dimensions.
  template <int D>
  page_scene<D> make() const {
    if (is_given) {
      const double size = Fd.norm();
      if (!(size > 0)) return {wall_or_force<D>(), 0};
      ph::contact<D> c;
      c.normal = ph::direction_of(ph::point<D>(Fd.head<D>()));
      c.depth = given_depth;
      c.stiffness = size / given_depth;
      c.sensed_at = at.head<D>();
      return {wall_or_force<D>(c), 0};
    }
    const any_shape<D>* shape = wall->shape<D>();
    return {shape == nullptr ? wall_or_force<D>() : wall_or_force<D>(*shape, stiffness),
            rate > 0 ? 1 / rate : 0};
  }
};

}  // namespace explorer
