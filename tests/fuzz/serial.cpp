// libFuzzer: the driver's port and the firmware on one serial line, which loses, adds and changes bytes. Both
// ends take what is a whole frame, and nothing else. No current passes the limit or outlives the watchdog,
// none flows that was not sent, and the host believes no count that was not in a frame.
#include "input.hpp"

#include <firmware/brake_controller.hpp>
#include <serial/serial_port.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace {

namespace ph = passive_haptics;
namespace serial = example::serial;
using example::serial_line;
using fuzz::require;
using bytes = std::vector<std::uint8_t>;

constexpr firmware::settings settings{};
constexpr std::uint32_t watchdog = 1000u * settings.watchdog;  // [us]
using port = example::serial_port<settings.encoders, settings.brakes>;
using brake_currents = std::array<std::uint16_t, settings.brakes>;

// A decoder as a reader of docs/guide/ports.md would test it: what it takes for a packet is written
// as the very bytes that came, and what was written as a frame it takes.
class checked_decoder {
 public:
  serial::outcome take(std::uint8_t b) {
    const serial::outcome o = tested_.take(b);
    const bytes came = segment_;
    segment_.push_back(b);
    if (b != 0) {
      require(o == serial::outcome::nothing, "a frame ends without its delimiter");
      return o;
    }
    segment_.clear();
    const bool listened = std::exchange(listens_, true);
    if (o == serial::outcome::packet) {
      require(listened && frame_of(tested_.last()) == came, "a packet of other bytes");
      require(tested_.last().size <= serial::max_payload, "a packet that is too long");
    } else {
      require((o == serial::outcome::damaged) == (listened && !came.empty()), "damage where there is none");
      require(!listened || std::find(sent_.begin(), sent_.end(), came) == sent_.end(),
              "a whole frame was not found");
    }
    return o;
  }
  const serial::packet& last() const { return tested_.last(); }
  // Somebody wrote this one.
  void sent(const serial::packet& p) {
    if (sent_.size() < 64) sent_.push_back(frame_of(p));
  }

 private:
  static bytes frame_of(const serial::packet& p) {
    const serial::frame f = serial::encode(p);
    require(f.size <= serial::max_frame && f.byte[0] == 0 && f.byte[f.size - 1] == 0,
            "a frame without its ends");
    return bytes(f.byte.begin() + 1, f.byte.begin() + static_cast<std::ptrdiff_t>(f.size - 1));
  }

  serial::decoder tested_;
  bytes segment_;            // since the last delimiter
  std::vector<bytes> sent_;  // without delimiters
  bool listens_ = false;     // since the first delimiter
};

struct board {
  brake_currents current{};

  void set_current(std::size_t i, std::uint16_t c) {
    require(c <= settings.current_limit, "a current over the limit");
    current[i] = c;
  }
  std::int32_t read_encoder(std::size_t i) { return counts[i]; }
  std::uint8_t encoder_faults() { return faults[0]; }
  std::uint8_t brake_faults() { return faults[1]; }
  void send(std::span<const std::uint8_t> frame) {
    serial_line::to_host.insert(serial_line::to_host.end(), frame.begin(), frame.end());
  }

  std::array<std::int32_t, settings.encoders> counts{};
  std::array<std::uint8_t, 2> faults{};
};

// Both ends, and what a test knows of what flows between them.
class bench {
 public:
  explicit bench(fuzz::reader& in) : in_(in), controller_(board_, settings), host_(parameters()) {
    serial_line::to_host.clear();
    serial_line::to_device.clear();
    serial_line::room = 4096;
    serial_line::waited = [this] {
      deliver(serial_line::to_device.size());
      pass(settings.period);
    };
    const std::string error = host_.open();
    require(error.empty(), "the host does not find the device", error);
    require(host_.device() == serial::hello{serial::protocol_version, settings.encoders, settings.brakes,
                                            settings.current_limit, settings.watchdog, settings.period},
            "another device");
    at_host_.take(0);  // it has heard whole frames
  }

  void step() {
    auto& to_device = serial_line::to_device;
    auto& to_host = serial_line::to_host;
    switch (in_.byte() % 13) {
      case 0: {
        ph::brake_currents<settings.brakes> wanted;
        for (double& one : wanted) one = in_.number();
        write(wanted);
        break;
      }
      case 1: {  // as above, in a byte
        const double one = in_.byte() / 256.0;
        write({one, 1 - one});
        break;
      }
      case 2: host_.release(); break;
      case 3: read(); break;
      case 4: pass(settings.period); break;
      case 5: pass(in_.word(2)); break;
      case 6: deliver(in_.byte()); break;
      case 7: spoil(to_device); break;
      case 8: spoil(to_host); break;
      case 9: noise(to_device); break;
      case 10: noise(to_host); break;
      case 11: {
        const serial::packet p = any_packet();
        const auto f = serial::encode(p);
        const bool up = p.type >= 0x80;
        if (!up) at_device_.sent(p);
        (up ? to_host : to_device)
            .insert((up ? to_host : to_device).end(), f.content().begin(), f.content().end());
        break;
      }
      default:
        for (auto& count : board_.counts) count = static_cast<std::int32_t>(in_.word(4));
        for (auto& fault : board_.faults) fault = in_.byte() % 4;
        serial_line::room = in_.byte() * 16u;
    }
  }

 private:
  static example::serial_port_parameters parameters() {
    example::serial_port_parameters p;
    p.open_timeout = 1;
    return p;
  }

  // Mostly a message as it should be, of any content.
  serial::packet any_packet() {
    struct kind {
      serial::message_type type;
      std::size_t size;
    };
    using enum serial::message_type;
    constexpr std::array kinds{kind{ask, 0}, kind{release, 0}, kind{currents, 2 * settings.brakes},
                               kind{hello, serial::detail::hello_size},
                               kind{sample, serial::detail::sample_head + 4 * settings.encoders}};
    const std::uint8_t choice = in_.byte();
    const kind& usual = kinds[choice % 8 % kinds.size()];
    serial::packet p;
    p.type = choice & 8 ? in_.byte() : static_cast<std::uint8_t>(usual.type);
    p.sequence = in_.byte();
    const auto content = in_.bytes(choice & 16 ? in_.byte() % (serial::max_payload + 1) : usual.size);
    p.size = static_cast<std::uint8_t>(content.size());
    std::copy(content.begin(), content.end(), p.payload.begin());
    return p;
  }

  // A bit turned, a byte lost or doubled, somewhere on the way.
  void spoil(std::deque<std::uint8_t>& line) {
    const std::uint8_t what = in_.byte();
    if (line.empty()) return;
    const auto at = line.begin() + static_cast<std::ptrdiff_t>(in_.word(2) % line.size());
    if (what % 4 == 0) line.erase(at);
    else if (what % 4 == 1) line.insert(at, *at);
    else *at = static_cast<std::uint8_t>(*at ^ 1u << what / 4 % 8);
  }
  void noise(std::deque<std::uint8_t>& line) {
    const auto some = in_.bytes(in_.byte() % 80);
    line.insert(line.end(), some.begin(), some.end());
  }

  void write(const ph::brake_currents<settings.brakes>& wanted) {
    constexpr std::size_t size =
        1 + 1 + serial::header_size + 2 * settings.brakes + serial::checksum_size + 1;  // of the frame
    const auto& line = serial_line::to_device;
    const std::size_t before = line.size();
    const bool fits = before + size <= serial_line::room;
    require(host_.write(wanted) == (fits ? ph::port_status::ok : ph::port_status::no_sample),
            "another status of write");
    require(fits || line.empty(), "late currents wait");
    if (!fits) return;
    serial::decoder sent;
    serial::currents m;
    for (std::size_t i = before; i < line.size(); ++i) sent.take(line[i]);
    require(line.size() == before + size && unpack(sent.last(), m) && m.brakes == settings.brakes,
            "no currents");
    at_device_.sent(sent.last());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const double most = settings.current_limit * serial::current_unit,
                   asked = wanted[i] > 0 ? wanted[i] : 0.0;
      require(std::abs(m.current[i] * serial::current_unit - std::min(asked, most)) <=
                  0.500001 * serial::current_unit,
              "another current than asked for");
    }
  }

  // The firmware gets so many bytes.
  void deliver(std::size_t most) {
    auto& line = serial_line::to_device;
    for (; most > 0 && !line.empty(); --most) {
      const std::uint8_t b = line.front();
      line.pop_front();
      controller_.receive(b, now_);
      expire();
      if (at_device_.take(b) == serial::outcome::packet) obey(at_device_.last());
      check_board();
    }
  }
  // So long passes [us], with a sample at its end.
  void pass(std::uint32_t time) {
    now_ += time;
    controller_.tick(now_);
    expire();
    check_board();
  }

  // What the protocol says of the brakes.
  void expire() {
    if (active_ && now_ - fed_ >= watchdog) expected_ = {}, active_ = false, tripped_ = true;
  }
  void obey(const serial::packet& p) {
    serial::currents m;
    if (unpack(p, serial::message_type::release)) {
      expected_ = {}, active_ = tripped_ = false;
    } else if (unpack(p, m) && m.brakes == settings.brakes && !tripped_) {
      for (std::size_t i = 0; i < expected_.size(); ++i)
        expected_[i] = std::min(m.current[i], settings.current_limit);
      active_ = true;
      fed_ = now_;
    }
  }
  void check_board() const { require(board_.current == expected_, "another current than the host's"); }

  // The host reads; the test reads the same bytes.
  void read() {
    constexpr std::size_t most = 4096;  // of one read() [bytes]
    const auto& line = serial_line::to_host;
    serial::sample newest;
    std::uint32_t sequence = 0;
    bool fresh = false, damaged = false;
    for (std::size_t i = 0; i < std::min(line.size(), most); ++i) {
      const serial::outcome o = at_host_.take(line[i]);
      serial::sample m;
      const bool is_sample = o == serial::outcome::packet && unpack(at_host_.last(), m);
      damaged = damaged || o == serial::outcome::damaged || (is_sample && m.encoders != settings.encoders);
      if (!is_sample || m.encoders != settings.encoders) continue;
      fresh = true;
      newest = m;
      sequence = at_host_.last().sequence;
    }
    ph::port_sample<settings.encoders> sample;
    const ph::port_status status = host_.read(sample);
    if (!fresh) {
      require(status == (damaged ? ph::port_status::bad_sample : ph::port_status::no_sample),
              "a status of nothing");
      return;
    }
    require(status == ph::port_status::ok || status == ph::port_status::failed, "a status of a sample");
    const bool on = (newest.state & serial::sample::active) != 0 && newest.brake_faults == 0;
    require(status == ph::port_status::ok || !on, "refused while the currents are on the brakes");
    require(sample.sequence == sequence && host_.newest() == newest, "another sample than the newest");
    require(std::isfinite(sample.time) && sample.time <= ph::monotonic_seconds(), "a sample of the future");
    for (std::size_t i = 0; i < settings.encoders; ++i) {
      require(sample.value[i] == newest.count[i], "another count");
      require(sample.valid[i] == ((newest.encoder_faults >> i & 1) == 0), "a fault of another encoder");
    }
  }

  fuzz::reader& in_;
  board board_;
  firmware::brake_controller<board> controller_;
  port host_;
  checked_decoder at_device_, at_host_;
  std::uint32_t now_ = 0, fed_ = 0;  // [us]
  bool active_ = false, tripped_ = false;
  brake_currents expected_{};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::reader in(data, size);
  bench b(in);
  while (!in.ended()) b.step();
  return 0;
}
