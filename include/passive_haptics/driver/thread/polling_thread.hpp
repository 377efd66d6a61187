/// A polling thread.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/driver/clock.hpp>

#include <pthread.h>

#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <utility>

namespace passive_haptics {

/// Parameters of polling_thread.
struct polling_parameters {
  double pause = 1e-4;  ///< Time between two looks [s]: a tenth of section 5.1's cycle.

  static constexpr const char* type_name = "a polling thread";  ///< In errors.
  static constexpr auto members() {
    return member_table(member("pause", &polling_parameters::pause, "s", range::between(1e-6, 1)));
  }
};

/// A thread that calls look() from start() to stop(), and once more at its end. Thread and owner share the
/// look, which stays valid even if it never returns. Inherits the starter's scheduling; receives no signals.
template <class Look>
class polling_thread {
 public:
  /// Maximum time that stop() waits for the current look, in addition to the pause [s].
  static constexpr double max_look_time = 1;

  /// Constructs the look from these arguments. Throws std::invalid_argument with the text of validate(p).
  template <class... Arguments>
  explicit polling_thread(const polling_parameters& p, Arguments&&... arguments)
      : shared_(std::make_shared<shared>(require_valid(p).pause, std::forward<Arguments>(arguments)...)) {}
  /// The thread continues; the look keeps its address.
  polling_thread(polling_thread&& other) noexcept
      : shared_(std::move(other.shared_)), thread_(other.thread_), runs_(std::exchange(other.runs_, false)) {}
  polling_thread& operator=(polling_thread&&) = delete;
  ~polling_thread() { stop(); }

  explicit operator bool() const noexcept { return shared_ != nullptr; }  ///< False if it was moved from.
  Look* operator->() const noexcept { return &shared_->look; }            ///< The look.

  /// Starts the thread. Returns an error or an empty string.
  std::string start() {
    auto own = std::make_unique<std::shared_ptr<shared>>(shared_);
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, stack);
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    const int error = pthread_create(&thread_, &attributes, run, own.get());
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    pthread_attr_destroy(&attributes);
    runs_ = error == 0;
    if (!runs_) return std::string("a port's thread: ").append(std::strerror(error));
    own.release();  // owned by the thread now
    return {};
  }

  bool runs() const noexcept { return runs_; }  ///< True if it was started and not stopped.

  /// Ends the thread after one more look. Returns false if the look has not returned after `pause` and
  /// max_look_time: the thread is detached and ends when it returns.
  bool stop() noexcept {
    if (!runs_) return true;
    runs_ = false;
    shared_->ends.store(true, std::memory_order_release);
    const monotonic_clock clock;
    const std::int64_t longest = shared_->pause + std::llround(1e9 * max_look_time);
    for (const std::int64_t end = clock.now() + longest; !shared_->ended.load(std::memory_order_acquire);) {
      if (clock.now() > end) {
        pthread_detach(thread_);
        return false;
      }
      clock.sleep_until(clock.now() + 100'000);
    }
    pthread_join(thread_, nullptr);
    return true;
  }

 private:
  static constexpr std::size_t stack = 1 << 20;  // [bytes]; locked completely if memory is

  struct shared {
    template <class... Arguments>
    explicit shared(double seconds, Arguments&&... arguments)
        : look(std::forward<Arguments>(arguments)...), pause(std::llround(1e9 * seconds)) {}
    Look look;
    std::int64_t pause;  // [ns]
    std::atomic<bool> ends = false, ended = false;
  };

  static void* run(void* given) noexcept {
    const std::shared_ptr<shared> own =
        std::move(*std::unique_ptr<std::shared_ptr<shared>>(static_cast<std::shared_ptr<shared>*>(given)));
    const monotonic_clock clock;
    for (bool last = false; !last;) {
      last = own->ends.load(std::memory_order_acquire);  // before the look, which then sees all commands
      own->look();
      if (!last) clock.sleep_until(clock.now() + own->pause);
    }
    own->ended.store(true, std::memory_order_release);
    return nullptr;
  }

  std::shared_ptr<shared> shared_;
  pthread_t thread_{};
  bool runs_ = false;
};

}  // namespace passive_haptics
