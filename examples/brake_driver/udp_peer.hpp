/// @file
/// Datagrams to and from one peer, without waiting.
#pragma once

#include <passive_haptics/core/validate.hpp>

#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <utility>

namespace example {

namespace ph = passive_haptics;

/// A socket that hears this peer alone. Nothing but open() allocates, waits or looks up a name.
class udp_peer {
 public:
  static constexpr ssize_t nothing =
      -1;                                ///< No datagram, or the network complains of an earlier one of ours.
  static constexpr ssize_t broken = -2;  ///< There is no socket, or none that works.

  udp_peer() = default;
  udp_peer(udp_peer&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  udp_peer& operator=(udp_peer&&) = delete;
  ~udp_peer() { close(); }

  /// Empty, or what is wrong. A peer that is not there is not noticed.
  std::string open(const std::string& host, int port) {
    close();
    addrinfo wanted{}, *found = nullptr;
    wanted.ai_socktype = SOCK_DGRAM;
    const int error = getaddrinfo(host.c_str(), std::to_string(port).c_str(), &wanted, &found);
    if (error != 0)
      return std::string("the name cannot be looked up (") + gai_strerror(error) +
             "); correct it, or give an address";
    std::string text;
    for (const addrinfo* a = found; a != nullptr && fd_ < 0; a = a->ai_next) {
      fd_ = socket(a->ai_family, a->ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, a->ai_protocol);
      if (fd_ >= 0 && connect(fd_, a->ai_addr, a->ai_addrlen) == 0) break;
      text = std::string("no way there: ") + std::strerror(errno) + "; is the network up?";
      close();
    }
    freeaddrinfo(found);
    return fd_ >= 0 ? "" : text;
  }

  /// Best effort.
  void send(std::span<const std::uint8_t> bytes) noexcept {
    if (fd_ >= 0 && ::send(fd_, bytes.data(), bytes.size(), MSG_NOSIGNAL) < 0) note(errno);
  }

  /// The length of the next datagram as it was sent, of which as much as fits is stored; or `nothing`; or `broken`.
  ssize_t receive(std::span<std::uint8_t> to) noexcept {
    if (fd_ < 0) return broken;
    for (;;) {
      const ssize_t n = recv(fd_, to.data(), to.size(), MSG_TRUNC);
      if (n >= 0) return n;
      if (errno == EINTR) continue;
      return note(errno) ? nothing : broken;
    }
  }

  /// Has the host said that nobody listens there, since this was asked last?
  bool refused() noexcept { return std::exchange(refused_, false); }

  /// Waits until something has come, at most so long [s].
  void wait(double timeout) noexcept {
    pollfd p{fd_, POLLIN, 0};
    poll(&p, 1, static_cast<int>(1e3 * timeout) + 1);
  }

  /// Nothing if it is not open.
  void close() noexcept {
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
  }

 private:
  int fd_ = -1;
  bool refused_ = false;

  // True for what passes by when the network or the peer comes back.
  bool note(int error) noexcept {
    if (error == ECONNREFUSED) refused_ = true;
    switch (error) {
      case EAGAIN:
      case ECONNREFUSED:
      case EHOSTUNREACH:
      case EHOSTDOWN:
      case ENETUNREACH:
      case ENETDOWN:
      case ENOBUFS:
      case ENOMEM: return true;
      default: return false;
    }
  }
};

}  // namespace example
