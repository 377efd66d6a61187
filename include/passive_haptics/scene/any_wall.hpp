/// @file
/// A wall whose shape is known at run time only.
#pragma once

#include <passive_haptics/scene/bounding_box.hpp>
#include <passive_haptics/scene/scene.hpp>

#include <memory>
#include <utility>

namespace passive_haptics {

/// Takes the contacts of a wall, one after the other.
template <int D>
class contact_sink {
 public:
  /// Takes one contact; its wall number may be missing.
  virtual void add(const contact<D>& c) = 0;

 protected:
  ~contact_sink() = default;
};

/// Holds a wall of any Shape. Copies share it, so they are cheap and safe in other threads.
template <int D>
class any_wall {
 public:
  /// A wall within bounds that hold all of it; for shapes that do not tell theirs.
  template <class S>
  any_wall(wall<S> w, const bounding_box<D>& bounds)
      : held_(std::make_shared<model<S>>(std::move(w))), bounds_(bounds) {
    static_assert(S::dimension == D, "passive_haptics: all walls of a world need the world's dimension.");
  }

  /// A wall within the bounds that its shape tells (BoundedShape), else anywhere.
  template <class S>
  explicit any_wall(const wall<S>& w) : any_wall(w, bounds_of<D>(w.shape)) {}

  /// A box that holds all of the wall.
  const bounding_box<D>& bounds() const { return bounds_; }

  /// How far [m] the handle may go from x without touching the wall; 0 if it touches it, then its contacts go to `found`.
  double look(const point<D>& x, contact_sink<D>& found) const { return held_->look(x, found); }

 private:
  struct concept_of_wall {
    virtual ~concept_of_wall() = default;
    virtual double look(const point<D>& x, contact_sink<D>& found) const = 0;
  };

  template <class S>
  struct model final : concept_of_wall {
    explicit model(wall<S> w) : held(std::move(w)) {}
    double look(const point<D>& x, contact_sink<D>& found) const override {
      const double distance = held.shape.distance(x);
      if (distance >= 0) return distance;
      contact<D> c;
      describe(held, x, distance, c);
      found.add(c);
      return 0;
    }
    wall<S> held;
  };

  std::shared_ptr<const concept_of_wall> held_;
  bounding_box<D> bounds_;
};

}  // namespace passive_haptics
