/// Exchange of scenes between a slow thread and a control loop.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/core/status.hpp>
#include <passive_haptics/scene/contacts.hpp>

#include <array>
#include <atomic>
#include <cmath>
#include <optional>
#include <utility>

namespace passive_haptics {

/// A wait-free triple buffer for whole scenes between two threads. The publishing thread destroys old scenes.
/// A fourth slot keeps the previous scene, from which the new one takes over the state of the handle.
template <class Scene>
class scene_exchange {
 public:
  static_assert(std::atomic<unsigned>::is_always_lock_free);

  /// Stores a first scene, valid at a time [s] on the clock of the control loop's states.
  scene_exchange(Scene first, double time) { slots_[reading_] = {std::move(first), time}; }

  /// Publishes a scene, valid at this time [s]. Call it from one thread at a time.
  void publish(Scene scene, double time) {
    slots_[writing_] = {std::move(scene), time};
    writing_ = handed_over_.exchange(writing_ | fresh, std::memory_order_acq_rel) & ~fresh;
  }

  Scene& scene() { return *slots_[reading_].scene; }     ///< The scene being read; only for the control loop.
  double time() const { return slots_[reading_].time; }  ///< Time of that scene [s].

  /// Switches to the latest scene, if there is a new one; only for the control loop. Wait-free.
  void update() noexcept {
    if ((handed_over_.load(std::memory_order_relaxed) & fresh) == 0) return;
    read_before_ = handed_over_.exchange(read_before_, std::memory_order_acq_rel) & ~fresh;
    std::swap(reading_, read_before_);
    if constexpr (requires(Scene& s) { s.remember(s); }) scene().remember(*slots_[read_before_].scene);
  }

 private:
  struct slot {
    std::optional<Scene> scene;
    double time = 0;
  };

  static constexpr unsigned fresh = 4;  // flag of a slot that was not read yet

  std::array<slot, 4> slots_;
  unsigned writing_ = 0;
  std::atomic<unsigned> handed_over_ = 1;
  unsigned reading_ = 2;
  unsigned read_before_ = 3;
};

/// Parameters of latest_scene.
struct latest_scene_parameters {
  /// Maximum age of a scene, also in the future [s]: twice the slowest period of section 5.2.
  double stale_after = 0.1;
  bool extrapolate = false;  ///< Extrapolates moving walls by their velocities.

  static constexpr const char* type_name = "a latest_scene";  ///< In errors.
  static constexpr auto members() {
    using p = latest_scene_parameters;
    return member_table(member("stale_after", &p::stale_after, "s", range::positive),
                        member("extrapolate", &p::extrapolate));
  }
};

/// The latest scene of an exchange, for a controller. An outdated scene is a fault, status::scene_stale: the
/// brakes are released, because the wall may have moved away.
template <class Scene>
class latest_scene {
 public:
  static constexpr int dimension = Scene::dimension;    ///< d
  using contacts_type = typename Scene::contacts_type;  ///< Contacts of the scene.

  /// The exchange must live longer. Throws std::invalid_argument with the text of validate(p), or if
  /// extrapolate is set and the scene has no extrapolate(seconds).
  explicit latest_scene(scene_exchange<Scene>& exchange, const latest_scene_parameters& p = {})
      : exchange_(&exchange), parameters_(require_valid(p)) {
    require_no_error(p.extrapolate && !can_extrapolate
                         ? "extrapolate of a latest_scene = true: expected a scene with extrapolate(seconds)"
                         : "");
  }

  /// Contacts of the latest scene at x [m] and a time [s].
  decltype(auto) touched_at(const point<dimension>& x, double time) {
    exchange_->update();
    age_ = time - exchange_->time();
    if constexpr (can_extrapolate) {
      if (parameters_.extrapolate && is_current()) exchange_->scene().extrapolate(age_);
    }
    if constexpr (SeesAhead<Scene>) exchange_->scene().set_margin(margin_);
    return sense(exchange_->scene(), x);
  }

  /// Sets the margin of this and all later scenes.
  void set_margin(double margin)
    requires SeesAhead<Scene>
  {
    margin_ = margin;
  }

  /// scene_stale if the latest scene is too old or in the future (another clock), else its status.
  friend status scene_status(const latest_scene& latest) {
    return latest.is_current() ? passive_haptics::status_of(latest.exchange_->scene()) : status::scene_stale;
  }

 private:
  static constexpr bool can_extrapolate = requires(Scene& s, double seconds) { s.extrapolate(seconds); };

  bool is_current() const { return std::abs(age_) <= parameters_.stale_after; }

  scene_exchange<Scene>* exchange_;
  latest_scene_parameters parameters_;
  double age_ = 0;     // of the scene in the latest cycle [s]
  double margin_ = 0;  // [m]
};

}  // namespace passive_haptics
