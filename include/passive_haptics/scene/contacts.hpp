/// Contacts of the end effector, the only input that a control step receives from a scene.
#pragma once

#include <passive_haptics/core/status.hpp>
#include <passive_haptics/scene/shape.hpp>

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>

namespace passive_haptics {

/// One touched wall.
template <int D>
struct contact {
  point<D> normal = point<D>::UnitX();        ///< Unit vector out of the wall, base frame.
  double depth = 0;                           ///< Penetration [m]. Only a depth > 0 demands a force.
  double stiffness = 0;                       ///< [N/m]
  point<D> wall_velocity = point<D>::Zero();  ///< Velocity of the touched surface [m/s].
  int wall_number = 0;                        ///< Index of the wall in the scene.
  /// End effector when the wall was sensed [m], moved with the wall since then. NaN if unset.
  point<D> sensed_at = point<D>::Constant(std::numeric_limits<double>::quiet_NaN());
  /// Hessian H of the wall's distance [1/m]. Motion along the surface at velocity v keeps the depth if n . a
  /// = -v^T H v. Zero for planes and for shapes that do not provide their curvature.
  matrix<double, D, D> curvature = matrix<double, D, D>::Zero();
};

/// Returns the contact as seen from x [m], extrapolated from the position at which it was sensed. With u = x
/// - sensed_at and l = sqrt(1 + |H u|^2),
///
///     normal = (n + H u) / l,   depth = depth_sensed - u . (n + H u / (1 + l)).
///
/// The result is exact to second order, and exact for u along a circle or ball.
template <int D>
contact<D> carried_to(const point<D>& x, contact<D> c) {
  const point<D> moved = x - c.sensed_at, turn = c.curvature * moved;
  const double length = std::sqrt(1 + turn.squaredNorm());
  c.depth -= moved.dot(c.normal + turn / (1 + length));
  c.normal = (c.normal + turn) / length;
  c.sensed_at = x;
  return c;
}

/// True if a direction has length 1, to 1e-6 (the accuracy of normals computed in float).
template <int D>
bool is_unit(const point<D>& direction) {
  return std::abs(direction.squaredNorm() - 1) <= 2e-6;
}

namespace detail {

// Up to Capacity values of X, without allocation. Unused elements are not constructed.
template <class X, int Capacity>
class static_vector {
  static_assert(std::is_trivially_destructible_v<X>);

 public:
  static_vector() {}
  static_vector(const static_vector& other) { *this = other; }
  static_vector& operator=(const static_vector& other) {
    size_ = other.size_;
    std::uninitialized_copy_n(other.data(), size_, data());
    return *this;
  }

  // Adds a value. Requires size() < Capacity.
  X& append(const X& x) { return *std::construct_at(data() + size_++, x); }
  void clear() { size_ = 0; }
  int size() const { return size_; }
  const X* data() const { return items_.data(); }
  X* data() { return items_.data(); }

 private:
  union {
    std::array<X, static_cast<std::size_t>(Capacity)> items_;
  };
  int size_ = 0;
};

// At most one value, always constructed: the optimiser cannot see through a union.
template <class X>
class static_vector<X, 1> {
 public:
  // Sets the value. Requires size() == 0.
  X& append(const X& x) {
    item_ = x;
    size_ = 1;
    return item_;
  }
  void clear() { size_ = 0; }
  int size() const { return size_; }
  const X* data() const { return &item_; }
  X* data() { return &item_; }

 private:
  X item_{};
  int size_ = 0;
};

}  // namespace detail

/// Up to Capacity contacts, without allocation.
template <int D, int Capacity>
class contacts {
 public:
  static constexpr int dimension = D;        ///< d
  static constexpr int capacity = Capacity;  ///< Maximum number of contacts.

  /// Adds a contact; false if Capacity are there already. A normal that is not a unit vector, or a negative
  /// stiffness, makes the depth NaN, so that the cycle ends with status::contact_invalid.
  bool push_back(const contact<D>& c) {
    if (items_.size() == Capacity) return false;
    contact<D>& added = items_.append(c);
    if (!is_unit(c.normal) || c.stiffness < 0) added.depth = std::numeric_limits<double>::quiet_NaN();
    return true;
  }

  /// Adds a contact with a unit normal and a stiffness >= 0. Requires size() < Capacity.
  void append_unchecked(const contact<D>& c) { items_.append(c); }

  void clear() { items_.clear(); }  ///< Removes all.

  int size() const { return items_.size(); }         ///< Number of contacts.
  bool empty() const { return items_.size() == 0; }  ///< True in free space.
  /// Contact i, 0 <= i < size().
  const contact<D>& operator[](int i) const {
    assert(0 <= i && i < size());
    if constexpr (Capacity == 1) return *items_.data();  // a constant for the optimiser
    return items_.data()[i];
  }
  const contact<D>* begin() const { return items_.data(); }                ///< First contact.
  const contact<D>* end() const { return items_.data() + items_.size(); }  ///< One past the last contact.
  contact<D>* begin() { return items_.data(); }                            ///< First contact.
  contact<D>* end() { return items_.data() + items_.size(); }              ///< One past the last contact.

 private:
  detail::static_vector<contact<D>, Capacity> items_;
};

/// A view of the only touched wall of a scene.
template <int D>
struct single_contact {
  static constexpr int dimension = D;  ///< d
  static constexpr int capacity = 1;   ///< Always 1.
  const contact<D>& only;              ///< The contact.

  constexpr int size() const { return 1; }                            ///< Always 1.
  constexpr bool empty() const { return false; }                      ///< Always false.
  constexpr const contact<D>& operator[](int) const { return only; }  ///< The contact.
};

/// Returns the contacts at x [m] by scene.touched_at(x), or at a time [s] by scene.touched_at(x, time).
template <class Scene, class... Time>
  requires requires(Scene& scene, point<Scene::dimension> x, Time... time) { scene.touched_at(x, time...); }
decltype(auto) sense(Scene& scene, const point<Scene::dimension>& x, Time... time) {
  return scene.touched_at(x, time...);
}

/// Overload for constant and temporary scenes.
template <class Scene, class... Time>
  requires requires(const Scene& scene, point<Scene::dimension> x, Time... time) {
    scene.touched_at(x, time...);
  }
auto sense(const Scene& scene, const point<Scene::dimension>& x, Time... time) {
  return scene.touched_at(x, time...);
}

/// A scene that can report contacts before the touch, with depth < 0. `void set_margin(double margin)` sets
/// the distance from a wall at which it starts to do so [m].
template <class S>
concept SeesAhead = requires(S& scene, double margin) { scene.set_margin(margin); };

/// Returns scene_status(scene) if it exists, for example status::scene_stale, else status::ok.
template <class S>
status status_of(const S& scene) {
  if constexpr (requires { scene_status(scene); }) return scene_status(scene);
  else return status::ok;
}

/// Returns the first contact, which must exist.
template <int D, int Capacity>
single_contact<D> as_single(const contacts<D, Capacity>& touched) {
  return {touched[0]};
}

}  // namespace passive_haptics
