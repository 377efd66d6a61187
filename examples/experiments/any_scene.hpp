/// Scenes chosen at run time.
#pragma once

#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/scene/contacts.hpp>

#include <memory>
#include <utility>

namespace experiments {

namespace ph = passive_haptics;

/// Holds a scene of one or many walls, with its state of the handle. Contacts are those of the scene, at the
/// cost of a virtual call. Copies have their own state. Capacity: maximum contacts, those of a world, or 1
/// for a law with one wall.
template <int D, int Capacity = D + 1>
class any_scene {
 public:
  static constexpr int dimension = D;               ///< d
  using contacts_type = ph::contacts<D, Capacity>;  ///< Type of the contacts.

  /// A scene with virtual functions.
  struct interface {
    virtual ~interface() = default;
    virtual std::unique_ptr<interface> copy() const = 0;
    /// See held_scene.
    virtual const contacts_type& touched_at(const ph::point<D>& x, double time) = 0;
    /// See world.
    virtual void set_margin(double margin) = 0;
    /// Forgets the handle and a held sample.
    virtual void reset() = 0;
  };

  explicit any_scene(std::unique_ptr<interface> held) : held_(std::move(held)) {}
  any_scene(const any_scene& other) : held_(other.held_->copy()) {}
  any_scene(any_scene&&) noexcept = default;
  any_scene& operator=(const any_scene& other) {
    held_ = other.held_->copy();
    return *this;
  }
  any_scene& operator=(any_scene&&) noexcept = default;
  ~any_scene() = default;

  /// The contacts at x [m] and a time [s], valid until the next call.
  const contacts_type& touched_at(const ph::point<D>& x, double time) { return held_->touched_at(x, time); }
  /// Reports contacts from this distance to each wall [m].
  void set_margin(double margin) { held_->set_margin(margin); }
  /// Forgets the handle and a held sample.
  void reset() { held_->reset(); }

 private:
  std::unique_ptr<interface> held_;
};

}  // namespace experiments
