/// @file
/// A scene that a slow thread owns and a control loop reads.
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

/// A triple buffer from one thread to one other: the latest scene, whole. Neither thread waits or locks. The
/// reader neither allocates nor frees: the thread that publishes destroys the scenes that are read no more.
///
/// Beside its three scenes (being written, handed over, being read) a fourth is kept: the one that was read
/// before. The new one takes over what it knew of the handle.
template <class Scene>
class scene_exchange {
 public:
  static_assert(std::atomic<unsigned>::is_always_lock_free);

  /// With a first scene, as it was at a time [s] on the clock of the control loop's states.
  scene_exchange(Scene first, double time) { slots_[reading_] = {std::move(first), time}; }

  /// Hands over a scene as it is at this time [s]. To be called by one thread at a time; it may take as long
  /// as it likes.
  void publish(Scene scene, double time) {
    slots_[writing_] = {std::move(scene), time};
    writing_ = handed_over_.exchange(writing_ | fresh, std::memory_order_acq_rel) & ~fresh;
  }

  /// The scene that is being read; the control loop's alone.
  Scene& scene() { return *slots_[reading_].scene; }
  /// When it was as it says [s].
  double time() const { return slots_[reading_].time; }

  /// Turns to the latest scene, if there is a new one; by the control loop alone. Wait-free.
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

  static constexpr unsigned fresh = 4;  // flag beside the number of a slot: not read yet

  std::array<slot, 4> slots_;
  unsigned writing_ = 0;
  std::atomic<unsigned> handed_over_ = 1;
  unsigned reading_ = 2;
  unsigned read_before_ = 3;
};

/// How a loop reads a scene of another thread.
struct latest_scene_parameters {
  /// A scene that is older than this, or that far in the future, is not displayed [s]; by default twice the
  /// period of the slowest scene of section 5.2.
  double stale_after = 0.1;
  /// Whether moving walls go on with the velocities that they were published with.
  bool extrapolate = false;

  static constexpr const char* type_name = "a latest_scene";  ///< In errors.
  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = latest_scene_parameters;
    return member_table(member("stale_after", &p::stale_after, "s", range::positive),
                        member("extrapolate", &p::extrapolate));
  }
};

/// The latest scene of an exchange, for a controller. A scene that is out of date is a fault,
/// status::scene_stale: the brakes are released rather than hold the hand at a wall that may have gone.
template <class Scene>
class latest_scene {
 public:
  static constexpr int dimension = Scene::dimension;    ///< d
  using contacts_type = typename Scene::contacts_type;  ///< As of the scene.

  /// The exchange must live longer. Throws std::invalid_argument with the text of validate(p), or if walls
  /// are to be extrapolated and the scene has no extrapolate(seconds).
  explicit latest_scene(scene_exchange<Scene>& exchange, const latest_scene_parameters& p = {})
      : exchange_(&exchange), parameters_(require_valid(p)) {
    require_no_error(p.extrapolate && !can_extrapolate
                         ? "extrapolate of a latest_scene = true, expected a scene with extrapolate(seconds)"
                         : "");
  }

  /// The contacts at x [m] and a time [s] of the latest scene.
  decltype(auto) touched_at(const point<dimension>& x, double time) {
    exchange_->update();
    age_ = time - exchange_->time();
    if constexpr (can_extrapolate) {
      if (parameters_.extrapolate && is_current()) exchange_->scene().extrapolate(age_);
    }
    if constexpr (SeesAhead<Scene>) exchange_->scene().set_margin(margin_);
    return sense(exchange_->scene(), x);
  }

  /// As of the scene: of that of now and of those to come.
  void set_margin(double margin)
    requires SeesAhead<Scene>
  {
    margin_ = margin;
  }

  /// scene_stale if the scene of the latest cycle was too old, or published in the future: by a clock that is
  /// not that of the states. Else the status of the scene.
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
