/// Live log for plotting: one JSON object per datagram, to a UDP port of this machine.
#pragma once

#include <log/log_row.hpp>
#include <udp_peer.hpp>

#include <condition_variable>
#include <deque>
#include <mutex>
#include <string>
#include <thread>

namespace example {

/// Sends rows immediately, without waiting. A receiver is optional.
class live_stream {
 public:
  /// Returns an error or an empty string. port 0: sends nothing.
  std::string open(int port) { return port == 0 ? "" : peer_.open("127.0.0.1", port); }
  void send(log_row& row) noexcept { send(row.json()); }
  void send(const std::string& json) noexcept {
    peer_.send({reinterpret_cast<const std::uint8_t*>(json.data()), json.size()});
  }

 private:
  udp_peer peer_;
};

/// A stream for a simulation: a thread sends each row when its time has passed since the start, in real time.
class paced_stream {
 public:
  /// Throws std::runtime_error.
  explicit paced_stream(int port);
  /// Waits until all rows are sent.
  ~paced_stream();
  paced_stream(const paced_stream&) = delete;
  paced_stream& operator=(const paced_stream&) = delete;

  /// time: of the row, since the start [s].
  void send(double time, log_row& row);

 private:
  struct message {
    double time;
    std::string json;
  };
  void send_all();

  bool off_;
  live_stream stream_;
  std::deque<message> waiting_;
  bool complete_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::thread sender_;
};

}  // namespace example
