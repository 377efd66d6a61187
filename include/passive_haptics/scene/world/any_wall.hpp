/// @file
/// A wall whose shape is known at run time only.
#pragma once

#include <passive_haptics/scene/bounds/bounding_box.hpp>
#include <passive_haptics/scene/scene.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <utility>

namespace passive_haptics {

/// Takes the contacts of a wall, one after the other.
template <int D>
class contact_sink {
 public:
  /// Takes one contact. What does not depend on the wall's shape (its number, where the handle is) may be
  /// missing.
  virtual void add(const contact<D>& c) = 0;

 protected:
  ~contact_sink() = default;
};

/// Holds a wall of any Shape or TrackedShape. Copies share it, so they are cheap and safe in other threads.
template <int D>
class any_wall {
 public:
  /// A wall within bounds that hold all of it; for shapes that do not tell theirs.
  template <class S>
  any_wall(wall<S> w, const bounding_box<D>& bounds)
      : held_(std::make_shared<model<S>>(std::move(w))), bounds_(bounds) {}

  /// A wall within the bounds that its shape tells, else anywhere.
  template <class S>
  explicit any_wall(const wall<S>& w) : any_wall(w, bounds_within_world(w.shape)) {}

  /// A box that holds all of the wall.
  const bounding_box<D>& bounds() const { return bounds_; }

  /// Whether both hold the same wall, not an equal one.
  bool shares(const any_wall& other) const { return held_ == other.held_; }

  /// Size of what is remembered of one handle [bytes]; 0 if nothing is.
  std::size_t tracker_size() const { return held_->tracker_size(); }

  /// Makes a tracker of a handle that was not seen yet, in tracker_size() bytes aligned for any type.
  void start_tracker(void* storage) const { held_->start_tracker(storage); }

  /// How far [m] the handle may go from x without touching the wall; 0 if it touches it, then its contacts go
  /// to `found`. In the cycle before it was at `from`.
  double look(const point<D>& from, const point<D>& x, void* tracker, contact_sink<D>& found) const {
    return held_->look(from, x, tracker, found);
  }

 private:
  template <class S>
  static bounding_box<D> bounds_within_world(const S& shape) {
    static_assert(S::dimension == D, "passive_haptics: all walls of a world need the world's dimension.");
    if constexpr (S::dimension == D) return bounds_of<D>(shape);
    else return {};
  }

  struct any_model {
    virtual ~any_model() = default;
    virtual std::size_t tracker_size() const = 0;
    virtual void start_tracker(void* storage) const = 0;
    virtual double look(const point<D>& from, const point<D>& x, void* tracker,
                        contact_sink<D>& found) const = 0;
  };

  template <class S>
  struct model final : any_model {
    explicit model(wall<S> w) : held(std::move(w)) {}

    std::size_t tracker_size() const override {
      if constexpr (TrackedShape<S>) return sizeof(typename S::tracker);
      else return 0;
    }
    void start_tracker(void* storage) const override {
      if constexpr (TrackedShape<S>) ::new (storage) typename S::tracker();
    }
    double look(const point<D>& from, const point<D>& x, void* tracker,
                contact_sink<D>& found) const override {
      if constexpr (TrackedShape<S>) {
        contact<D> c;
        c.stiffness = held.stiffness;
        return held.shape.follow(from, x, *static_cast<typename S::tracker*>(tracker),
                                 [&](const point<D>& normal, double depth) {
                                   c.normal = normal;
                                   c.depth = depth;
                                   found.add(c);
                                 });
      } else {
        const double distance = held.shape.distance(x);
        if (distance >= 0) return distance;
        contact<D> c;
        describe(held, x, distance, c);
        found.add(c);
        return 0;
      }
    }

    wall<S> held;
  };

  std::shared_ptr<const any_model> held_;
  bounding_box<D> bounds_;
};

}  // namespace passive_haptics
