/// Datagrams to and from one peer, without waiting.
#pragma once

#include <file_descriptor.hpp>

#include <passive_haptics/core/parameters.hpp>

#include <netdb.h>
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

/// A socket that only receives from this peer. Only open() allocates, waits or looks up a name.
class udp_peer {
 public:
  static constexpr ssize_t nothing = -1;  ///< No datagram, or an error of an earlier one.
  static constexpr ssize_t broken = -2;   ///< No working socket.

  /// Returns an error or an empty string. A missing peer is not detected.
  std::string open(const std::string& host, int port) {
    close();
    addrinfo wanted{}, *found = nullptr;
    wanted.ai_socktype = SOCK_DGRAM;
    const int error = getaddrinfo(host.c_str(), std::to_string(port).c_str(), &wanted, &found);
    if (error != 0)
      return std::string("the name cannot be looked up (") + gai_strerror(error) +
             "); correct it, or give an address";
    std::string text;
    for (const addrinfo* a = found; a != nullptr && !fd_.is_open(); a = a->ai_next) {
      fd_ = file_descriptor(
          socket(a->ai_family, a->ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, a->ai_protocol));
      if (fd_.is_open() && connect(fd_.get(), a->ai_addr, a->ai_addrlen) == 0) break;
      text = std::string("no way there: ") + std::strerror(errno) + "; is the network up?";
      close();
    }
    freeaddrinfo(found);
    return fd_.is_open() ? "" : text;
  }

  /// Best effort.
  void send(std::span<const std::uint8_t> bytes) noexcept {
    if (fd_.is_open() && ::send(fd_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL) < 0) note(errno);
  }

  /// Length of the next datagram as sent, stored as far as it fits; or `nothing`, or `broken`.
  ssize_t receive(std::span<std::uint8_t> to) noexcept {
    if (!fd_.is_open()) return broken;
    for (;;) {
      const ssize_t n = recv(fd_.get(), to.data(), to.size(), MSG_TRUNC);
      if (n >= 0) return n;
      if (errno == EINTR) continue;
      return note(errno) ? nothing : broken;
    }
  }

  /// True if the host reported a closed port since the last call.
  bool refused() noexcept { return std::exchange(refused_, false); }

  /// Waits for a datagram, at most `timeout` [s].
  void wait(double timeout) const noexcept { fd_.wait(timeout); }

  void close() noexcept { fd_.close(); }

 private:
  file_descriptor fd_;
  bool refused_ = false;

  // True for temporary errors.
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
