// A UDP socket on the loopback interface. Its peer is the socket that sent to it last.
#pragma once

#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstddef>

class loopback_socket {
 public:
  // At any free port, or at this one.
  explicit loopback_socket(int wanted_port = 0)
      : number_(::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {
    sockaddr_in here{AF_INET, htons(static_cast<std::uint16_t>(wanted_port)), {htonl(INADDR_LOOPBACK)}, {}};
    socklen_t size = sizeof here;
    EXPECT_EQ(bind(number_, reinterpret_cast<sockaddr*>(&here), size), 0);
    EXPECT_EQ(getsockname(number_, reinterpret_cast<sockaddr*>(&here), &size), 0);
    port_ = ntohs(here.sin_port);
  }
  loopback_socket(const loopback_socket&) = delete;
  loopback_socket& operator=(const loopback_socket&) = delete;
  ~loopback_socket() { ::close(number_); }

  int port() const { return port_; }
  const sockaddr_in& peer() const { return peer_; }

  // The size of the next datagram, or less than 0 if there is none.
  ssize_t receive(void* to, std::size_t most) {
    socklen_t size = sizeof peer_;
    return recvfrom(number_, to, most, 0, reinterpret_cast<sockaddr*>(&peer_), &size);
  }
  ssize_t send(const void* from, std::size_t size) { return send(from, size, peer_); }
  ssize_t send(const void* from, std::size_t size, const sockaddr_in& to) {
    return sendto(number_, from, size, 0, reinterpret_cast<const sockaddr*>(&to), sizeof to);
  }

 private:
  int number_, port_ = 0;
  sockaddr_in peer_{};
};
