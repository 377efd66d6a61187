/// Walls with a type-erased shape.
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

/// An immutable wall of any Shape, ProxySurface or TrackedShape, shared by its copies. Its shape is not
/// extrapolated; add moving walls by world_walls::add_moving.
template <int D>
class any_wall {
 public:
  /// A wall with bounds that contain it, for shapes without bounds().
  template <class S>
  any_wall(wall<S> w, const bounding_box<D>& bounds)
      : held_(std::make_shared<model<S>>(std::move(w), bounds)) {}

  /// A wall with the bounds of its shape; infinite without bounds().
  template <class S>
  any_wall(const wall<S>& w) : any_wall(w, bounds_of(w.shape)) {}

  const bounding_box<D>& bounds() const { return held_->bounds(); }  ///< Bounding box.

  /// True if both share one wall; equal walls do not suffice.
  bool shares(const any_wall& other) const { return held_ == other.held_; }

  /// True if the wall has an inside that pushes a handle out: a Shape.
  bool is_solid() const { return held_->is_solid(); }

  /// True if the wall requires a proxy: a mesh, or a plate or bar that a hand could press through.
  bool needs_proxy() const { return held_->needs_proxy(); }

  /// The obstacle for a proxy; nullptr for a TrackedShape that is not a ProxySurface.
  const any_proxy_surface<D>* surface() const { return held_->surface(); }

  /// The contact of a handle with its proxy at p [m], without normal, depth and number.
  contact<D> contact_by_proxy(const point<D>& p) const { return held_->contact_by_proxy(p); }

  /// Size of the state for one handle [bytes]; 0 for none.
  std::size_t tracker_size() const { return held_->tracker_size(); }

  /// Constructs a tracker of a new handle in tracker_size() bytes aligned for any type.
  void start_tracker(void* storage) const { held_->start_tracker(storage); }

  /// Returns the distance [m] that the handle at x may move without coming nearer than `margin` [m] to the
  /// wall; it was at `from` in the previous cycle. If it is nearer, returns 0 and adds its contacts to the
  /// empty `found`, without wall number. A TrackedShape ignores the margin and leaves the position out.
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
      constexpr double wide = 0.02;  // [m]; a hand slips off smaller walls
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
        return 0;  // handled by its surface
      }
    }

    wall<S> held;
    bounding_box<D> box;  // initialised after `held`
    detail::stops_of<S> stops;
  };

  std::shared_ptr<const any_model> held_;
};

}  // namespace passive_haptics
