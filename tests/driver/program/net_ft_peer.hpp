// A force sensor on the loopback interface.
#pragma once

#include "../loopback_socket.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <thread>

namespace program {

// A Net F/T force sensor that sends a record each millisecond to who asked last, until it falls silent; of a
// hand that trembles, or of none.
class net_ft_peer {
 public:
  net_ft_peer() : sender_([this] { serve(); }) {}
  ~net_ft_peer() {
    ended_ = true;
    sender_.join();
  }
  int port() const { return socket_.port(); }
  void fall_silent() { silent_ = true; }
  void tremble(bool does) { trembles_ = does; }

 private:
  void serve() {
    bool asked = false;
    for (std::uint32_t sequence = 1; !ended_; usleep(1000)) {
      std::array<std::uint8_t, 8> request;
      while (socket_.receive(request.data(), request.size()) == static_cast<ssize_t>(request.size()))
        asked = request[3] == 2;
      if (!asked || silent_) continue;
      const std::uint32_t tremor = trembles_ ? sequence % 2 * 2'000'000 : 0;  // 2 N
      const std::array<std::uint32_t, 9> words{htonl(sequence), htonl(sequence), 0, htonl(300'000 + tremor)};
      ++sequence;
      socket_.send(words.data(), sizeof words);
    }
  }

  loopback_socket socket_;
  std::atomic<bool> ended_ = false, silent_ = false, trembles_ = false;
  std::thread sender_;
};

}  // namespace program
