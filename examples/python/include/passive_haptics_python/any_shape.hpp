/// @file
/// A shape that is known at run time only.
#pragma once

#include <passive_haptics/scene/bounds/bounding_box.hpp>
#include <passive_haptics/scene/shape.hpp>

#include <memory>
#include <utility>

namespace passive_haptics_python {

namespace ph = passive_haptics;

/// Holds a Shape at rest whose gradient is a unit vector. Copies share it. A scene of it gives the contacts
/// that a scene of the shape itself gives, at the cost of a virtual call for each number.
template <int D>
class any_shape {
  using point = ph::point<D>;
  using square = ph::matrix<double, D, D>;

  struct interface {
    virtual ~interface() = default;
    virtual double distance(const point& x) const = 0;
    virtual point gradient(const point& x) const = 0;
    virtual square hessian(const point& x) const = 0;
    virtual ph::bounding_box<D> bounds() const = 0;
    virtual double thickness() const = 0;
  };
  template <class S>
  struct model final : interface {
    explicit model(S s) : shape(std::move(s)) {}
    double distance(const point& x) const override { return shape.distance(x); }
    point gradient(const point& x) const override { return shape.gradient(x); }
    square hessian(const point& x) const override { return ph::surface_curvature(shape, x); }
    ph::bounding_box<D> bounds() const override {
      if constexpr (requires { shape.bounds(); }) return shape.bounds();
      else return ph::everywhere<D>();
    }
    double thickness() const override { return ph::thickness_of(shape); }
    S shape;
  };

 public:
  static constexpr int dimension = D;              ///< d
  static constexpr bool has_unit_gradient = true;  ///< As of all that it may hold.

  /// Holds this shape.
  template <ph::Shape S>
    requires(!std::same_as<S, any_shape>)
  explicit any_shape(S shape) : held_(std::make_shared<model<S>>(std::move(shape))) {
    static_assert(ph::gradient_is_unit<S> && !ph::MovingShape<S> && S::dimension == D);
  }

  /// Signed distance [m].
  double distance(const point& x) const { return held_->distance(x); }
  /// Unit vector to the free side.
  point gradient(const point& x) const { return held_->gradient(x); }
  /// Second derivative of the distance [1/m]; zero of a shape that provides none.
  square hessian(const point& x) const { return held_->hessian(x); }
  /// A box that holds the shape.
  ph::bounding_box<D> bounds() const { return held_->bounds(); }
  /// The smallest distance between two opposite sides [m].
  double thickness() const { return held_->thickness(); }

  /// The shape itself if it is an S, else nullptr.
  template <class S>
  const S* as() const {
    const auto* found = dynamic_cast<const model<S>*>(held_.get());
    return found == nullptr ? nullptr : &found->shape;
  }

 private:
  std::shared_ptr<const interface> held_;
};

}  // namespace passive_haptics_python
