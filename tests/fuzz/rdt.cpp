// libFuzzer: datagrams of an ATI Net F/T. Each record reads back as the bytes that it came in; a reading is
// that of the newest whole record, in its units, and trusted only where the status says so.
#include "input.hpp"

#include <ports/net_ft.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace {

namespace ph = passive_haptics;
using example::net_ft;
using example::rdt_record;
using example::udp_peer;
using fuzz::require;
using bytes = std::vector<std::uint8_t>;

// As the sensor writes it.
bytes written(const rdt_record& r) {
  bytes all;
  const auto put = [&](std::uint32_t word) {
    for (int shift = 24; shift >= 0; shift -= 8) all.push_back(static_cast<std::uint8_t>(word >> shift));
  };
  for (const std::uint32_t word : {r.sequence, r.ft_sequence, r.status}) put(word);
  for (const std::int32_t count : r.counts) put(static_cast<std::uint32_t>(count));
  return all;
}

// Its bits but those of a threshold that was once exceeded, which the summary in bit 31 may go with.
bool is_fault(std::uint32_t status) {
  const bool only_threshold = status == 0x0001'0000u || status == 0x8001'0000u;
  return status != 0 && !only_threshold;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::reader in(data, size);
  const double per_force = 1 + in.word(3), per_torque = 1 + in.word(3);
  net_ft sensor({.counts_per_force = per_force, .counts_per_torque = per_torque});
  udp_peer::datagrams.clear();
  while (!in.ended()) {
    std::vector<rdt_record> whole;
    bool other = false;
    for (int n = in.byte() % 8; n > 0; --n) {
      const std::uint8_t length = in.byte();  // mostly that of a record
      const auto taken = in.bytes(length < 192 ? rdt_record::size : length - 192u);
      const bytes one(taken.begin(), taken.end());
      udp_peer::datagrams.push_back(one);
      if (one.size() == rdt_record::size) {
        whole.push_back(rdt_record::from(std::span<const std::uint8_t, rdt_record::size>(one)));
        require(written(whole.back()) == one, "a record is written as other bytes");
      } else {
        other = true;
      }
    }
    ph::port_sample<net_ft::channel_count> sample;
    const ph::port_status status = sensor.read(sample);
    require(udp_peer::datagrams.empty(), "a datagram was left");
    const auto expected = !whole.empty() ? ph::port_status::ok
                          : other        ? ph::port_status::bad_sample
                                         : ph::port_status::no_sample;
    require(status == expected, "another status");
    if (whole.empty()) continue;
    // Older ones never win over the next; modulo 2^32 there need be no newest of all
    rdt_record newest = whole.front();
    for (const auto& r : whole)
      if (const std::uint32_t ahead = r.sequence - newest.sequence; ahead != 0 && ahead < 0x8000'0000u)
        newest = r;
    require(sample.sequence == newest.sequence && sensor.status() == newest.status, "not the newest record");
    for (std::size_t i = 0; i < newest.counts.size(); ++i) {
      const double unit = i < 3 ? per_force : per_torque;
      require(std::lround(sample.value[i] * unit) == newest.counts[i], "a count in other units");
      require(std::abs(sample.value[i]) <= 0x1p31 / unit, "more than the sensor can count");
      require(sample.valid[i] != is_fault(newest.status), "trusted against the status, or not with it");
    }
  }
  return 0;
}
