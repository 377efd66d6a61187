/// Board-independent firmware: currents in, samples out, and 0 A if the host is silent.
#pragma once

#include <serial/serial_protocol.hpp>

#include <concepts>

namespace firmware {

namespace serial = example::serial;

/// Functions of a board:
///
///     void set_current(std::size_t brake, std::uint16_t current);  // [serial::current_unit], immediately
///     std::int32_t read_encoder(std::size_t encoder);              // counts modulo 2^32
///     std::uint8_t encoder_faults(), brake_faults();               // bit i: channel i
///     void send(std::span<const std::uint8_t>);                    // a frame or nothing; does not wait
template <class B>
concept Board = requires(B board, std::size_t i, std::uint16_t current, std::span<const std::uint8_t> bytes) {
  board.set_current(i, current);
  { board.read_encoder(i) } -> std::same_as<std::int32_t>;
  { board.encoder_faults() } -> std::same_as<std::uint8_t>;
  { board.brake_faults() } -> std::same_as<std::uint8_t>;
  board.send(bytes);
};

/// Properties of the board, sent to the host in the hello.
struct settings {
  std::uint8_t encoders = 2;           ///< At most serial::max_channels.
  std::uint8_t brakes = 2;             ///< At most serial::max_channels.
  std::uint16_t current_limit = 5000;  ///< [serial::current_unit]: 0.5 A.
  std::uint16_t watchdog = 20;         ///< [ms]
  std::uint16_t period = 1000;         ///< Period of tick() [us].
};

/// The states of the brakes.
enum class state : std::uint8_t {
  released,  ///< 0 A; at the start, and after a release. Currents switch to active.
  active,    ///< Currents of the host. Without any for the watchdog's time: tripped.
  tripped,   ///< 0 A; currents are ignored. A release switches to released.
};

/// A brake controller on a board. Only complete packets count, and currents only for this number of brakes;
/// silence, noise or incomplete packets do not feed the watchdog. Currents never exceed the limit.
template <Board B>
class brake_controller {
 public:
  /// Sets 0 A. The board must live longer.
  brake_controller(B& board, const settings& s) : board_(board), settings_(s) { enter(state::released); }

  /// Processes a byte received at this time [us, modulo 2^32].
  void receive(std::uint8_t byte, std::uint32_t now) {
    check_watchdog(now);  // first: late currents find the brakes tripped
    if (decoder_.take(byte) == serial::outcome::packet) obey(decoder_.last(), now);
  }

  /// Call it once per period with the time [us, modulo 2^32]: checks the watchdog and sends a sample. Silence
  /// gives 0 A within watchdog + period.
  void tick(std::uint32_t now) {
    check_watchdog(now);
    serial::sample m;
    m.encoders = settings_.encoders;
    m.time = now;
    for (std::size_t i = 0; i < settings_.encoders; ++i) m.count[i] = board_.read_encoder(i);
    m.state = static_cast<std::uint8_t>((state_ == state::active ? serial::sample::active : 0) |
                                        (state_ == state::tripped ? serial::sample::tripped : 0) |
                                        (limited_ ? serial::sample::limited : 0));
    m.encoder_faults = board_.encoder_faults();
    m.brake_faults = board_.brake_faults();
    send(serial::pack(samples_++, m));
  }

  state now_in() const { return state_; }

 private:
  B& board_;
  settings settings_;
  serial::decoder decoder_;
  state state_ = state::released;
  bool limited_ = false;
  std::uint32_t fed_ = 0;  // time of the last currents [us]
  std::uint32_t samples_ = 0, hellos_ = 0;

  void enter(state s) {
    state_ = s;
    limited_ = false;
    for (std::size_t i = 0; i < settings_.brakes; ++i) board_.set_current(i, 0);
  }

  void check_watchdog(std::uint32_t now) {
    if (state_ == state::active && now - fed_ >= std::uint32_t{1000} * settings_.watchdog)
      enter(state::tripped);
  }

  void send(const serial::packet& p) { board_.send(serial::encode(p).content()); }

  void obey(const serial::packet& p, std::uint32_t now) {
    serial::currents m;
    if (unpack(p, serial::message_type::release)) {
      enter(state::released);
    } else if (unpack(p, m) && m.brakes == settings_.brakes) {
      if (state_ == state::tripped) return;
      apply(m);
      state_ = state::active;
      fed_ = now;
    } else if (unpack(p, serial::message_type::ask)) {
      send(serial::pack(hellos_++,
                        serial::hello{serial::protocol_version, settings_.encoders, settings_.brakes,
                                      settings_.current_limit, settings_.watchdog, settings_.period}));
    }
  }

  void apply(const serial::currents& m) {
    limited_ = false;
    for (std::size_t i = 0; i < settings_.brakes; ++i) {
      const bool over = m.current[i] > settings_.current_limit;
      limited_ = limited_ || over;
      board_.set_current(i, over ? settings_.current_limit : m.current[i]);
    }
  }
};

}  // namespace firmware
