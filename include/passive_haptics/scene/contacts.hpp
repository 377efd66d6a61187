/// @file
/// What the end effector touches, as a value: all that a control step receives of a scene.
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
  double depth = 0;                           ///< Penetration [m]; a wall demands no force unless it is > 0.
  double stiffness = 0;                       ///< Of the wall [N/m].
  point<D> wall_velocity = point<D>::Zero();  ///< Of the touched surface [m/s].
  int wall_number = 0;                        ///< Which wall of the scene.
  /// Where the end effector was when the wall was sensed [m], moved along with the wall since then. NaN until
  /// it is set, which a law that reads it rejects.
  point<D> sensed_at = point<D>::Constant(std::numeric_limits<double>::quiet_NaN());
  /// Hessian H of the wall's distance [1/m]. Along the surface at velocity v, n . a = -v^T H v keeps the
  /// depth. Zero for planes, and for shapes that do not provide their curvature.
  matrix<double, D, D> curvature = matrix<double, D, D>::Zero();
};

/// The contact as the handle has it at x [m], carried there from where it was sensed: with u = x - sensed_at
/// and l = sqrt(1 + |H u|^2),
///
///     normal = (n + H u) / l,   depth = depth_sensed - u . (n + H u / (1 + l)).
///
/// This is right to second order, and exact on a circle or ball if u is along it. It changes nothing where
/// the contact was sensed.
template <int D>
contact<D> carried_to(const point<D>& x, contact<D> c) {
  const point<D> moved = x - c.sensed_at, turn = c.curvature * moved;
  const double length = std::sqrt(1 + turn.squaredNorm());
  c.depth -= moved.dot(c.normal + turn / (1 + length));
  c.normal = (c.normal + turn) / length;
  c.sensed_at = x;
  return c;
}

/// Whether a direction has length 1, to 1e-6: a program that computes normals in float is that exact.
template <int D>
bool is_unit(const point<D>& direction) {
  return std::abs(direction.squaredNorm() - 1) <= 2e-6;
}

namespace detail {

// Up to Capacity values of X; no allocation. Room that is not used costs nothing: no value is made there.
template <class X, int Capacity>
class static_vector {
  static_assert(std::is_trivially_destructible_v<X>);

 public:
  // Empty.
  static_vector() {}
  // A copy of each value.
  static_vector(const static_vector& other) { *this = other; }
  // A copy of each value.
  static_vector& operator=(const static_vector& other) {
    size_ = other.size_;
    std::uninitialized_copy_n(other.data(), size_, data());
    return *this;
  }

  // Adds a value. Fewer than Capacity must be there.
  X& append(const X& x) { return *std::construct_at(data() + size_++, x); }
  // Empties it.
  void clear() { size_ = 0; }
  // How many values there are.
  int size() const { return size_; }
  // The first value.
  const X* data() const { return items_.data(); }
  // The first value, to change it.
  X* data() { return items_.data(); }

 private:
  union {
    std::array<X, static_cast<std::size_t>(Capacity)> items_;
  };
  int size_ = 0;
};

// At most one value, which is made in advance: the optimiser sees through it, but not through a union.
template <class X>
class static_vector<X, 1> {
 public:
  // Sets the value. None must be there.
  X& append(const X& x) {
    item_ = x;
    size_ = 1;
    return item_;
  }
  // Empties it.
  void clear() { size_ = 0; }
  // 0 or 1.
  int size() const { return size_; }
  // The value.
  const X* data() const { return &item_; }
  // The value, to change it.
  X* data() { return &item_; }

 private:
  X item_{};
  int size_ = 0;
};

}  // namespace detail

/// Up to Capacity touched walls; no allocation.
template <int D, int Capacity>
class contacts {
 public:
  static constexpr int dimension = D;        ///< d
  static constexpr int capacity = Capacity;  ///< Most contacts at once.

  /// Adds a contact; false, and nothing added, if Capacity are there already. A contact whose normal is no
  /// unit vector, or whose stiffness is negative, gets a NaN depth, so that a cycle ends with
  /// status::contact_invalid.
  bool push_back(const contact<D>& c) {
    if (items_.size() == Capacity) return false;
    contact<D>& added = items_.append(c);
    if (!is_unit(c.normal) || c.stiffness < 0) added.depth = std::numeric_limits<double>::quiet_NaN();
    return true;
  }

  /// Adds a contact whose normal is a unit vector and whose stiffness is not negative. Fewer than Capacity
  /// must be there.
  void append_unchecked(const contact<D>& c) { items_.append(c); }

  /// Removes all.
  void clear() { items_.clear(); }

  /// Number of contacts.
  int size() const { return items_.size(); }
  /// True in free space.
  bool empty() const { return items_.size() == 0; }
  /// Contact i, 0 <= i < size().
  const contact<D>& operator[](int i) const {
    assert(0 <= i && i < size());
    if constexpr (Capacity == 1) return *items_.data();  // a constant, so that the optimiser sees through it
    return items_.data()[i];
  }
  /// First contact.
  const contact<D>* begin() const { return items_.data(); }
  /// One past the last contact.
  const contact<D>* end() const { return items_.data() + items_.size(); }
  /// First contact, to change it.
  contact<D>* begin() { return items_.data(); }
  /// One past the last contact.
  contact<D>* end() { return items_.data() + items_.size(); }

 private:
  detail::static_vector<contact<D>, Capacity> items_;
};

/// One of several walls, the only one that is touched: a view of its contact.
template <int D>
struct single_contact {
  static constexpr int dimension = D;  ///< d
  static constexpr int capacity = 1;   ///< Contacts.
  const contact<D>& only;              ///< The contact.

  /// 1
  constexpr int size() const { return 1; }
  /// False.
  constexpr bool empty() const { return false; }
  /// The contact.
  constexpr const contact<D>& operator[](int) const { return only; }
};

/// The contacts at x [m] of a scene that returns them by touched_at(x), or by touched_at(x, time) at a time
/// [s].
template <class Scene, class... Time>
  requires requires(Scene& scene, point<Scene::dimension> x, Time... time) { scene.touched_at(x, time...); }
decltype(auto) sense(Scene& scene, const point<Scene::dimension>& x, Time... time) {
  return scene.touched_at(x, time...);
}

/// The contacts at x [m], or at x and a time [s], of a scene that does not change, also of a temporary one.
template <class Scene, class... Time>
  requires requires(const Scene& scene, point<Scene::dimension> x, Time... time) {
    scene.touched_at(x, time...);
  }
auto sense(const Scene& scene, const point<Scene::dimension>& x, Time... time) {
  return scene.touched_at(x, time...);
}

/// A scene that can give contacts before the touch: `void set_margin(double margin)`, the distance off each
/// wall from which on it gives them [m]; their depth is < 0 until the touch.
template <class S>
concept SeesAhead = requires(S& scene, double margin) { scene.set_margin(margin); };

/// Why the contacts of a scene cannot be displayed, such as status::scene_stale, by its scene_status(scene);
/// status::ok for a scene without one.
template <class S>
status status_of(const S& scene) {
  if constexpr (requires { scene_status(scene); }) return scene_status(scene);
  else return status::ok;
}

/// The wall, where one is touched.
template <int D, int Capacity>
single_contact<D> as_single(const contacts<D, Capacity>& touched) {
  return {touched[0]};
}

}  // namespace passive_haptics
