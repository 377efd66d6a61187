/// @file
/// A wall whose shape is known at run time only.
#pragma once

#include <passive_haptics/core/flatten.hpp>
#include <passive_haptics/scene/bounds/bounding_box.hpp>
#include <passive_haptics/scene/proxy/shape_surface.hpp>
#include <passive_haptics/scene/wall.hpp>
#include <passive_haptics/scene/world/tracked_shape.hpp>

#include <memory>
#include <new>
#include <utility>

namespace passive_haptics {

/// Holds a wall of any Shape, ProxySurface or TrackedShape. Copies share it, so they are cheap and safe in
/// other threads. It never changes, so extrapolate() of its shape is not called: add a wall that moves with
/// world_walls::add_moving.
template <int D>
class any_wall {
 public:
  /// A wall within bounds that hold all of it; for shapes that do not provide theirs.
  template <class S>
  any_wall(wall<S> w, const bounding_box<D>& bounds)
      : held_(std::make_shared<model<S>>(std::move(w), bounds)) {}

  /// A wall within the bounds that its shape provides, else anywhere.
  template <class S>
  any_wall(const wall<S>& w) : any_wall(w, bounds_of(w.shape)) {}

  /// A box that holds all of the wall.
  const bounding_box<D>& bounds() const { return held_->bounds(); }

  /// Whether both hold the same wall, not an equal one.
  bool shares(const any_wall& other) const { return held_ == other.held_; }

  /// Whether the wall has an inside from which a handle is pushed out: a Shape.
  bool is_solid() const { return held_->is_solid(); }

  /// True if the wall needs a proxy of the handle: a mesh, or a plate or bar through which a hand would
  /// press.
  bool needs_proxy() const { return held_->needs_proxy(); }

  /// What stops a proxy; nullptr for a TrackedShape that is no ProxySurface.
  const any_proxy_surface<D>* surface() const { return held_->surface(); }

  /// The contact of a handle whose proxy is at p [m], but for its normal, depth and number.
  contact<D> contact_by_proxy(const point<D>& p) const { return held_->contact_by_proxy(p); }

  /// Size of what is remembered of one handle [bytes]; 0 if nothing is.
  std::size_t tracker_size() const { return held_->tracker_size(); }

  /// Makes a tracker of a handle that was not seen yet, in tracker_size() bytes aligned for any type.
  void start_tracker(void* storage) const { held_->start_tracker(storage); }

  /// How far [m] the handle may go from x without coming nearer than `margin` [m] to the wall; in the cycle
  /// before, the handle was at `from`. If it is nearer: 0, and its contacts are added to `found`, which has
  /// been empty. The contacts lack what the shape does not provide: the wall's number and, of a TrackedShape,
  /// the position. A TrackedShape gives contacts from the touch on, whatever the margin.
  double look(const point<D>& from, const point<D>& x, double margin, void* tracker,
              contacts<D, D>& found) const {
    return held_->look(from, x, margin, tracker, found);
  }

 private:
  template <class S>
  static bounding_box<D> bounds_of(const S& shape) {
    static_assert(S::dimension == D, "passive_haptics: all walls of a world need the world's dimension.");
    if constexpr (S::dimension != D) return {};
    else if constexpr (requires { shape.bounds(); }) return shape.bounds();
    else return everywhere<D>();
  }

  struct any_model {
    virtual ~any_model() = default;
    virtual const bounding_box<D>& bounds() const = 0;
    virtual bool is_solid() const = 0;
    virtual bool needs_proxy() const = 0;
    virtual const any_proxy_surface<D>* surface() const = 0;
    virtual contact<D> contact_by_proxy(const point<D>& p) const = 0;
    virtual std::size_t tracker_size() const = 0;
    virtual void start_tracker(void* storage) const = 0;
    virtual double look(const point<D>& from, const point<D>& x, double margin, void* tracker,
                        contacts<D, D>& found) const = 0;
  };

  template <class S>
  struct model final : any_model {
    static_assert(
        Shape<S> || TrackedShape<S>,
        "passive_haptics: a wall with a tracker needs a TrackedShape (scene/world/tracked_shape.hpp).");
    static constexpr bool is_followed = TrackedShape<S> && !ProxySurface<S>;
    model(wall<S> w, const bounding_box<D>& b) : held(std::move(w)), box(b), stops(held.shape) {}

    const bounding_box<D>& bounds() const override { return box; }
    bool is_solid() const override { return Shape<S>; }
    bool needs_proxy() const override {
      constexpr double thin = 0.01;  // [m], five times the rest_depth of the recommended law
      constexpr double wide = 0.02;  // [m]; off what is smaller a hand slips
      if constexpr (ProxySurface<S> || !Shape<S>) return ProxySurface<S>;
      else return thickness_of(held.shape) < thin && (box.upper - box.lower).maxCoeff() > wide;
    }
    const any_proxy_surface<D>* surface() const override { return stops.surface(); }
    contact<D> contact_by_proxy(const point<D>& p) const override {
      if constexpr (ProxySurface<S> || !Shape<S>) return {.stiffness = held.stiffness()};
      else return contact_of(held, p, 0);
    }
    std::size_t tracker_size() const override {
      if constexpr (is_followed) return sizeof(typename S::tracker);
      else return 0;
    }
    void start_tracker(void* storage) const override {
      if constexpr (is_followed) ::new (storage) typename S::tracker();
    }
    PASSIVE_HAPTICS_FLATTEN double look(const point<D>& from, const point<D>& x, double margin, void* tracker,
                                        contacts<D, D>& found) const override {
      if constexpr (is_followed) {
        const auto add = [&](const point<D>& normal, double depth) {
          found.push_back({.normal = normal, .depth = depth, .stiffness = held.stiffness()});
        };
        return held.shape.follow(from, x, *std::launder(static_cast<typename S::tracker*>(tracker)), add);
      } else if constexpr (Shape<S>) {
        const double distance = held.shape.distance(x);
        if (distance >= margin) return distance - margin;
        found.append_unchecked(contact_of(held, x, distance));
        return 0;
      } else {
        return 0;  // by its surface
      }
    }

    wall<S> held;
    bounding_box<D> box;  // after what is looked at
    detail::stops_of<S> stops;
  };

  std::shared_ptr<const any_model> held_;
};

}  // namespace passive_haptics
