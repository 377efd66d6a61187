// A force sensor on the loopback interface.
#pragma once

#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <thread>

namespace program {

// A Net F/T force sensor that sends a record each millisecond to who asked last, until it falls silent; of a
// hand that trembles, or of none.
class net_ft_peer {
 public:
  net_ft_peer() : socket_(socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {
    sockaddr_in here{};
    here.sin_family = AF_INET;
    here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof here;
    EXPECT_EQ(bind(socket_, reinterpret_cast<sockaddr*>(&here), size), 0);
    EXPECT_EQ(getsockname(socket_, reinterpret_cast<sockaddr*>(&here), &size), 0);
    port_ = ntohs(here.sin_port);
    sender_ = std::thread([this] { serve(); });
  }
  ~net_ft_peer() {
    ended_ = true;
    sender_.join();
    close(socket_);
  }
  int port() const { return port_; }
  void fall_silent() { silent_ = true; }
  void tremble(bool does) { trembles_ = does; }

 private:
  void serve() {
    sockaddr_in host{};
    bool asked = false;
    for (std::uint32_t sequence = 1; !ended_; usleep(1000)) {
      std::array<std::uint8_t, 8> request;
      socklen_t size = sizeof host;
      while (recvfrom(socket_, request.data(), request.size(), 0, reinterpret_cast<sockaddr*>(&host),
                      &size) == static_cast<ssize_t>(request.size()))
        asked = request[3] == 2;
      if (!asked || silent_) continue;
      const std::uint32_t tremor = trembles_ ? sequence % 2 * 2'000'000 : 0;  // 2 N
      const std::array<std::uint32_t, 9> words{htonl(sequence), htonl(sequence), 0, htonl(300'000 + tremor)};
      ++sequence;
      sendto(socket_, words.data(), sizeof words, 0, reinterpret_cast<sockaddr*>(&host), size);
    }
  }

  int socket_, port_ = 0;
  std::atomic<bool> ended_ = false, silent_ = false, trembles_ = false;
  std::thread sender_;
};

}  // namespace program
