/// @file
/// A scene that is known at run time only.
#pragma once

#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/scene/contacts.hpp>

#include <memory>
#include <utility>

namespace experiments {

namespace ph = passive_haptics;

/// Holds a scene of one wall or of many, and what it remembers of the handle. Gives the contacts that the
/// scene itself gives, at the cost of a virtual call. Each copy has its own memory of the handle.
/// Capacity: most contacts at once; that of a world, or 1 for a law that takes one wall.
template <int D, int Capacity = D + 1>
class any_scene {
 public:
  static constexpr int dimension = D;               ///< d
  using contacts_type = ph::contacts<D, Capacity>;  ///< What sensing this scene gives.

  /// A scene behind virtual functions.
  struct interface {
    /// As of a base class.
    virtual ~interface() = default;
    /// A copy with a memory of its own.
    virtual std::unique_ptr<interface> copy() const = 0;
    /// See held_scene.
    virtual const contacts_type& touched_at(const ph::point<D>& x, double time) = 0;
    /// See world.
    virtual void set_margin(double margin) = 0;
    /// Forgets the handle, and the latest sample where one is held.
    virtual void reset() = 0;
  };

  /// Holds this one.
  explicit any_scene(std::unique_ptr<interface> held) : held_(std::move(held)) {}
  /// A copy with a memory of its own.
  any_scene(const any_scene& other) : held_(other.held_->copy()) {}
  /// Takes over what another one holds.
  any_scene(any_scene&&) noexcept = default;
  /// As by a copy.
  any_scene& operator=(const any_scene& other) {
    held_ = other.held_->copy();
    return *this;
  }
  /// Takes over what another one holds.
  any_scene& operator=(any_scene&&) noexcept = default;
  ~any_scene() = default;

  /// The contacts at x [m] and a time [s], valid until the next call.
  const contacts_type& touched_at(const ph::point<D>& x, double time) { return held_->touched_at(x, time); }
  /// Gives contacts from this distance [m] off each wall on.
  void set_margin(double margin) { held_->set_margin(margin); }
  /// Forgets the handle, and the latest sample where one is held.
  void reset() { held_->reset(); }

 private:
  std::unique_ptr<interface> held_;
};

}  // namespace experiments
