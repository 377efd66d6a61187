/// Scenes chosen at run time, the interface between geometry and controllers. Contacts are passed by value.
#pragma once

#include <passive_haptics/scene/contacts.hpp>

#include <concepts>
#include <memory>
#include <type_traits>
#include <utility>

namespace passive_haptics::runtime {

/// Holds a scene of D dimensions with at most D + 1 contacts: a world, a static_scene, a held_scene of one.
/// Copies have their own state of the handle. Contacts are those of the scene, at the cost of a virtual call.
template <int D>
class any_scene {
 public:
  static constexpr int dimension = D;        ///< d
  using contacts_type = contacts<D, D + 1>;  ///< Type of the contacts.

  /// Holds this scene.
  template <class S>
    requires(!std::same_as<S, any_scene> && S::dimension == D)
  explicit any_scene(S scene) : held_(std::make_unique<model<S>>(std::move(scene))) {}
  /// A copy with its own memory.
  any_scene(const any_scene& other) : held_(other.held_->copy()) {}
  /// Moves.
  any_scene(any_scene&&) noexcept = default;
  /// A copy with its own memory.
  any_scene& operator=(const any_scene& other) {
    held_ = other.held_->copy();
    return *this;
  }
  /// Moves.
  any_scene& operator=(any_scene&&) noexcept = default;
  ~any_scene() = default;

  /// The contacts at x [m] and a time [s], valid until the next call.
  const contacts_type& touched_at(const point<D>& x, double time) { return held_->touched_at(x, time); }
  /// Reports contacts from this distance to each wall [m], if the scene can (SeesAhead).
  void set_margin(double margin) { held_->set_margin(margin); }
  /// Forgets the handle and a held sample.
  void reset() { held_->reset(); }

 private:
  struct any_model {
    virtual ~any_model() = default;
    virtual std::unique_ptr<any_model> copy() const = 0;
    virtual const contacts_type& touched_at(const point<D>& x, double time) = 0;
    virtual void set_margin(double margin) = 0;
    virtual void reset() = 0;
  };

  template <class S>
  struct model final : any_model {
    static_assert(S::contacts_type::capacity <= contacts_type::capacity);
    explicit model(S given) : scene(std::move(given)) {}
    std::unique_ptr<any_model> copy() const override { return std::make_unique<model>(*this); }
    const contacts_type& touched_at(const point<D>& x, double time) override {
      if constexpr (std::is_same_v<decltype(sensed(x, time)), const contacts_type&>) {
        return sensed(x, time);
      } else {
        touched.clear();
        for (const contact<D>& c : sensed(x, time)) touched.append_unchecked(c);
        return touched;
      }
    }
    void set_margin(double margin) override {
      if constexpr (SeesAhead<S>) scene.set_margin(margin);
    }
    void reset() override {
      if constexpr (requires { scene.reset(); }) scene.reset();
    }

    decltype(auto) sensed(const point<D>& x, double time) {
      if constexpr (requires { sense(scene, x, time); }) return sense(scene, x, time);
      else return sense(scene, x);
    }

    S scene;
    contacts_type touched;
  };

  std::unique_ptr<any_model> held_;
};

/// The contact with the maximum desired force, for laws with one contact.
template <int D>
class strongest_contact_of {
 public:
  static constexpr int dimension = D;    ///< d
  using contacts_type = contacts<D, 1>;  ///< Type of the contacts.

  /// Selects from this scene.
  explicit strongest_contact_of(any_scene<D> scene) : scene_(std::move(scene)) {}
  /// The contact at x [m] and a time [s].
  contacts_type touched_at(const point<D>& x, double time) {
    contacts_type one;
    const contact<D>* strongest = nullptr;
    for (const contact<D>& c : scene_.touched_at(x, time))  // NaN is selected, so that it is reported
      if (strongest == nullptr || !(c.stiffness * c.depth <= strongest->stiffness * strongest->depth))
        strongest = &c;
    if (strongest != nullptr) one.append_unchecked(*strongest);
    return one;
  }
  /// As the scene.
  void set_margin(double margin) { scene_.set_margin(margin); }
  /// As the scene.
  void reset() { scene_.reset(); }

 private:
  any_scene<D> scene_;
};

}  // namespace passive_haptics::runtime
