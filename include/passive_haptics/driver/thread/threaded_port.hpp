/// @file
/// A port, or a force sensor, whose transfers may wait, for a loop that must not.
#pragma once

#include <passive_haptics/driver/port.hpp>
#include <passive_haptics/driver/thread/mailbox.hpp>
#include <passive_haptics/driver/thread/polling_thread.hpp>

#include <atomic>
#include <cstdint>
#include <string>
#include <utility>

namespace passive_haptics {

/// Samples of N channels, from the thread that reads them to the thread that uses them.
template <int N>
class sample_mailbox {
 public:
  /// By the thread that reads: how a read ended.
  void put(port_status status, const port_sample<N>& sample) noexcept {
    if (status == port_status::no_sample) return;
    put_.failed = status == port_status::failed;
    put_.damaged += status == port_status::bad_sample;
    if (status == port_status::ok) {
      put_.sample = sample;
      ++put_.good;
    }
    box_.put(put_);
  }

  /// For the other thread: status and sample of the newest read since the last take().
  port_status take(port_sample<N>& sample) noexcept {
    const std::uint32_t good = taken_.good, damaged = taken_.damaged;
    box_.take(taken_);
    if (taken_.failed) return port_status::failed;
    if (taken_.good != good) {
      sample = taken_.sample;
      return port_status::ok;
    }
    return taken_.damaged != damaged ? port_status::bad_sample : port_status::no_sample;
  }

 private:
  struct arrivals {
    port_sample<N> sample;  // the newest
    std::uint32_t good = 0, damaged = 0;
    bool failed = false;  // the last of them
  };
  arrivals put_, taken_;
  mailbox<arrivals> box_;
};

/// A BrakePort: the one it is made of, whose read, write and release are called by a thread of its own, which
/// looks every `pause`. Here they are some loads and stores: no system call, whatever the device, the kernel
/// or a bus does. open() still may wait.
///
/// read: the newest sample that the thread read since, as old as it says. Else what it found instead.
/// write: leaves the currents for the thread, which hands each over once and newer ones in place of older. So
/// nothing feeds a device's watchdog but the loop. The status is that of the currents before; no_sample where
/// the thread has not come to them yet.
/// release: from any thread or signal handler. Overtakes currents that still lie here. 0 A leave this
/// computer after at most `pause` and the transfer under way. If that transfer does not end, 0 A is the
/// matter of a supervisor (safe_port::applied()) and of the device's watchdog, which gets no currents.
/// The destructor releases, and waits for the thread at most polling_thread::stop()'s time. A port that is
/// kept by a transfer longer than that lives on until the transfer ends.
///
/// Start other processes before open(), and set the scheduling before, which the thread inherits. A
/// supervisor takes the port itself: it may wait, and has to be done when it ends.
template <class Port>
class threaded_port {
  static_assert(is_port<Port, explain>());

 public:
  using port_type = Port;                                    ///< What a supervisor takes.
  static constexpr int encoder_count = Port::encoder_count;  ///< Encoders.
  static constexpr int brake_count = Port::brake_count;      ///< Brakes.

  /// Throws std::invalid_argument with the text of validate(p).
  explicit threaded_port(Port port, const polling_parameters& p = {}) : thread_(p, std::move(port)) {}
  /// The thread goes on; what it was moved from releases nothing.
  threaded_port(threaded_port&&) noexcept = default;
  ~threaded_port() { release(); }  // then the thread's last look carries it out

  /// Opens the port and starts the thread.
  std::string open() {
    std::string error = thread_->port.open();
    return error.empty() ? thread_.start() : error;
  }

  /// See above.
  port_status read(port_sample<encoder_count>& sample) noexcept {
    return thread_.runs() ? thread_->samples.take(sample) : thread_->port.read(sample);
  }
  /// See above.
  port_status write(const brake_currents<brake_count>& currents) noexcept {
    return thread_.runs() ? thread_->leave(currents) : thread_->port.write(currents);
  }
  /// See above.
  void release() noexcept {
    if (!thread_) return;  // moved from
    if (thread_.runs()) thread_->releases.fetch_add(1, std::memory_order_release);
    else thread_->port.release();
  }
  /// Of the port's counters.
  int counter_bits() const noexcept { return passive_haptics::counter_bits(thread_->port); }
  /// Of the device.
  double watchdog() const noexcept { return passive_haptics::watchdog(thread_->port); }

 private:
  struct order {
    brake_currents<brake_count> currents{};
    std::uint32_t number = 0;
    std::uint32_t releases = 0;  // that came before
  };
  struct answer {
    std::uint32_t number = 0;  // of the order
    port_status status = port_status::ok;
  };

  // What loop and thread share
  struct exchange {
    explicit exchange(Port p) : port(std::move(p)) {}

    Port port;  // the thread's alone while it runs
    sample_mailbox<encoder_count> samples;
    mailbox<order> orders;
    mailbox<answer> answers;
    std::atomic<std::uint32_t> releases = 0;
    std::uint32_t ordered = 0, released = 0;
    answer last;

    // By the loop
    port_status leave(const brake_currents<brake_count>& currents) noexcept {
      answers.take(last);
      const bool answered = last.number == ordered;
      orders.put({currents, ++ordered, releases.load(std::memory_order_relaxed)});
      return answered || last.status == port_status::failed ? last.status : port_status::no_sample;
    }

    // By the thread. The order before the count, so that no release after which it came is missed; a read
    // last: it is what may wait
    void operator()() noexcept {
      order next;
      const bool ordered_anew = orders.take(next);
      const std::uint32_t wanted = releases.load(std::memory_order_acquire);
      if (wanted != released) port.release();
      released = wanted;
      if (ordered_anew)
        answers.put({next.number, next.releases == released ? port.write(next.currents) : port_status::ok});
      port_sample<encoder_count> sample;
      const port_status status = port.read(sample);
      samples.put(status, sample);
    }
  };

  polling_thread<exchange> thread_;
};

/// A ForceSensor in the same way: the one it is made of, read by a thread of its own.
template <ForceSensor Sensor>
class threaded_sensor {
 public:
  static constexpr int channel_count = Sensor::channel_count;  ///< As of the sensor.

  /// Throws std::invalid_argument with the text of validate(p).
  explicit threaded_sensor(Sensor sensor, const polling_parameters& p = {}) : thread_(p, std::move(sensor)) {}

  /// Opens the sensor and starts the thread.
  std::string open() {
    std::string error = thread_->sensor.open();
    return error.empty() ? thread_.start() : error;
  }
  /// The newest sample since, else what the thread found instead: some loads and stores.
  port_status read(port_sample<channel_count>& sample) noexcept {
    return thread_.runs() ? thread_->samples.take(sample) : thread_->sensor.read(sample);
  }

 private:
  struct exchange {
    explicit exchange(Sensor s) : sensor(std::move(s)) {}

    Sensor sensor;  // the thread's alone while it runs
    sample_mailbox<channel_count> samples;

    void operator()() noexcept {
      port_sample<channel_count> sample;
      const port_status status = sensor.read(sample);
      samples.put(status, sample);
    }
  };

  polling_thread<exchange> thread_;
};

}  // namespace passive_haptics
