/// Shapes chosen at run time.
#pragma once

#include <passive_haptics/scene/bounds/bounding_box.hpp>
#include <passive_haptics/scene/shape.hpp>

#include <concepts>
#include <memory>
#include <utility>

namespace passive_haptics::runtime {

/// Holds a Shape with a unit gradient, and its optional members. Shared by its copies. Contacts are those of
/// the shape, at the cost of one virtual call per value.
template <int D>
class any_shape {
  using square = matrix<double, D, D>;

 public:
  static constexpr int dimension = D;              ///< d
  static constexpr bool has_unit_gradient = true;  ///< Required of the shape.

  /// Holds this shape.
  template <Shape S>
    requires(!std::same_as<S, any_shape>)
  explicit any_shape(S shape) : held_(std::make_shared<model<S>>(std::move(shape))) {
    static_assert(gradient_is_unit<S> && S::dimension == D);
  }

  /// Signed distance [m].
  double distance(const point<D>& x) const { return held_->distance(x); }
  /// Unit vector to the free side.
  point<D> gradient(const point<D>& x) const { return held_->gradient(x); }
  /// Hessian of the distance [1/m]; zero if the shape has none.
  square hessian(const point<D>& x) const { return held_->hessian(x); }
  /// Velocity of the surface [m/s]; zero if the shape does not move.
  point<D> velocity(const point<D>& x) const { return held_->velocity(x); }
  /// Bounding box.
  bounding_box<D> bounds() const { return held_->bounds(); }
  /// Minimum distance between opposite sides [m].
  double thickness() const { return held_->thickness(); }

 private:
  struct any_model {
    virtual ~any_model() = default;
    virtual double distance(const point<D>& x) const = 0;
    virtual point<D> gradient(const point<D>& x) const = 0;
    virtual square hessian(const point<D>& x) const = 0;
    virtual point<D> velocity(const point<D>& x) const = 0;
    virtual bounding_box<D> bounds() const = 0;
    virtual double thickness() const = 0;
  };
  template <class S>
  struct model final : any_model {
    explicit model(S s) : shape(std::move(s)) {}
    double distance(const point<D>& x) const override { return shape.distance(x); }
    point<D> gradient(const point<D>& x) const override { return shape.gradient(x); }
    square hessian(const point<D>& x) const override { return surface_curvature(shape, x); }
    point<D> velocity(const point<D>& x) const override { return surface_velocity(shape, x); }
    bounding_box<D> bounds() const override {
      if constexpr (requires { shape.bounds(); }) return shape.bounds();
      else return everywhere<D>();
    }
    double thickness() const override { return thickness_of(shape); }
    S shape;
  };

  std::shared_ptr<const any_model> held_;
};

}  // namespace passive_haptics::runtime
