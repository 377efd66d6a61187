/// Ports and force sensors with blocking transfers, for a real-time loop.
#pragma once

#include <passive_haptics/driver/port.hpp>
#include <passive_haptics/driver/thread/mailbox.hpp>
#include <passive_haptics/driver/thread/polling_thread.hpp>

#include <atomic>
#include <cstdint>
#include <string>
#include <utility>

namespace passive_haptics {

/// Samples of N channels, from a reading thread to another.
template <int N>
class sample_mailbox {
 public:
  /// For the reading thread: stores the result of a read.
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

  /// For the other thread: status and sample of the latest read since the last take().
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

/// A BrakePort that calls read, write and release of another port in a thread every `pause`. Its own
/// functions are a few loads and stores without system calls; only open() may wait.
///
/// read: the latest new sample of the thread, with its sampling time, or else the thread's status.
/// write: passes the currents to the thread, which writes each once; newer currents replace older ones, so
/// only the loop feeds a device's watchdog. Returns the status of the previous currents; no_sample if they
/// are pending.
/// release: from any thread or signal handler. Overtakes pending currents. 0 A is sent after at most `pause`
/// and the current transfer; if that does not end, it is left to a supervisor (safe_port::applied()) and the
/// device's watchdog. The destructor releases, and waits for the thread at most the time of
/// polling_thread::stop().
///
/// Fork other processes and set the scheduling before open(). A supervisor uses the port itself, which may
/// wait.
template <class Port>
class threaded_port {
  static_assert(is_port<Port, explain>());

 public:
  using port_type = Port;                                    ///< Port for a supervisor.
  static constexpr int encoder_count = Port::encoder_count;  ///< Number of encoders.
  static constexpr int brake_count = Port::brake_count;      ///< Number of brakes.

  /// Throws std::invalid_argument with the text of validate(p).
  explicit threaded_port(Port port, const polling_parameters& p = {}) : thread_(p, std::move(port)) {}
  /// The thread continues; the moved-from port releases nothing.
  threaded_port(threaded_port&&) noexcept = default;
  ~threaded_port() { release(); }  // carried out by the thread's last look

  /// Opens the port and starts the thread.
  std::string open() {
    std::string error = thread_->port.open();
    return error.empty() ? thread_.start() : error;
  }

  /// See the class.
  port_status read(port_sample<encoder_count>& sample) noexcept {
    return thread_.runs() ? thread_->samples.take(sample) : thread_->port.read(sample);
  }
  /// See the class.
  port_status write(const brake_currents<brake_count>& currents) noexcept {
    return thread_.runs() ? thread_->leave(currents) : thread_->port.write(currents);
  }
  /// See the class.
  void release() noexcept {
    if (!thread_) return;  // moved from
    if (thread_.runs()) thread_->releases.fetch_add(1, std::memory_order_release);
    else thread_->port.release();
  }
  /// As the port.
  int counter_bits() const noexcept { return passive_haptics::counter_bits(thread_->port); }
  double watchdog() const noexcept { return passive_haptics::watchdog(thread_->port); }  ///< As the port.

 private:
  struct order {
    brake_currents<brake_count> currents{};
    std::uint32_t number = 0;
    std::uint32_t releases = 0;  // preceding it
  };
  struct answer {
    std::uint32_t number = 0;  // of the order
    port_status status = port_status::ok;
  };

  struct exchange {
    explicit exchange(Port p) : port(std::move(p)) {}

    Port port;  // used only by the thread while it runs
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

    // By the thread. The order before the count, so that no earlier release is missed; the read may wait
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

/// The counterpart of threaded_port for a ForceSensor.
template <ForceSensor Sensor>
class threaded_sensor {
 public:
  static constexpr int channel_count = Sensor::channel_count;  ///< As the sensor.

  /// Throws std::invalid_argument with the text of validate(p).
  explicit threaded_sensor(Sensor sensor, const polling_parameters& p = {}) : thread_(p, std::move(sensor)) {}

  /// Opens the sensor and starts the thread.
  std::string open() {
    std::string error = thread_->sensor.open();
    return error.empty() ? thread_.start() : error;
  }
  /// The latest new sample of the thread, or else its status; a few loads and stores.
  port_status read(port_sample<channel_count>& sample) noexcept {
    return thread_.runs() ? thread_->samples.take(sample) : thread_->sensor.read(sample);
  }

 private:
  struct exchange {
    explicit exchange(Sensor s) : sensor(std::move(s)) {}

    Sensor sensor;  // used only by the thread while it runs
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
