// What a device adds to the table: its mechanism under each law, along one wall and two.
#pragma once

#include "states.hpp"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

// The assembler adds to these (assembler/count.awk).
extern "C" std::uint64_t counted_instructions, uncounted_calls;

namespace worst_case {

struct device {
  std::string name;
  std::function<void(long states)> print;  // its rows
};

// Filled before main, by the other files of this folder.
inline std::vector<device>& devices() {
  static std::vector<device> all;
  return all;
}

// A device along this number of walls under a law.
template <class M, class Law, int Walls>
class law_row {
 public:
  explicit law_row(const M& mechanism) : control_(mechanism, ph::brakes_of<M>(), walls(), Law()) {}

  void count(const situation<M>& at) {
    auto control = control_;
    control.scene().template get<0>().shape = at.walls[0];
    if constexpr (Walls == 2) control.scene().template get<1>().shape = at.walls[1];
    cycle(control, at.before);
    const std::uint64_t calls = uncounted_calls, start = counted_instructions;
    const bool ok = cycle(control, at.now);
    const std::uint64_t instructions = counted_instructions - start;
    calls_ += uncounted_calls - calls;
    ++total_;
    if (!at.is_hard && ok) sum_ += double(instructions), ++ordinary_;
    if (std::uint64_t& worst = at.is_hard ? worst_hard_ : worst_ordinary_; instructions > worst)
      worst = instructions;
  }

  void print(const std::string& device, const char* law) const {
    std::printf("%-24s %5d  %-26s %8.0f %9llu %9llu\n", device.c_str(), Walls, law, sum_ / double(ordinary_),
                static_cast<unsigned long long>(worst_ordinary_),
                static_cast<unsigned long long>(worst_hard_));
    if (calls_ != 0)
      std::printf(
          "  %.2g calls a cycle are of functions that were compiled elsewhere: see assembler/count.awk\n",
          double(calls_) / double(total_));
    std::fflush(stdout);
  }

 private:
  static auto walls() {
    using shape = ph::half_space<M::task_dimension>;
    const auto out = ph::point<M::task_dimension>::Unit(0);
    const auto wall = [&] { return ph::wall(shape(ph::point<M::task_dimension>::Zero(), out), 1e4); };
    if constexpr (Walls == 1) return ph::scene(wall());
    else return ph::scene(wall(), wall());
  }

  using controller = ph::controller<M, decltype(walls()), Law>;

  // The whole account. Inlined nowhere, so that what is counted ends with it.
  [[gnu::noinline]] static bool cycle(controller& control, const ph::device_state<M>& state) {
    const auto result = control(state);
    asm volatile("" : : "g"(&result) : "memory");
    return result.outcome == ph::status::ok;
  }

  controller control_;
  std::uint64_t worst_ordinary_ = 0, worst_hard_ = 0, calls_ = 0;
  double sum_ = 0;
  long total_ = 0, ordinary_ = 0;
};

// The laws of these walls, all on each state.
template <int Walls, class M, class... Laws>
void print_rows(const std::string& name, const M& mechanism, long count,
                const std::pair<const char*, Laws>&... laws) {
  states<M> source(mechanism);
  std::tuple<law_row<M, Laws, Walls>...> rows{law_row<M, Laws, Walls>(mechanism)...};
  for (long k = 0, shown = std::time(nullptr); k < count; ++k) {
    const situation<M> at = source.next();
    std::apply([&](auto&... row) { (row.count(at), ...); }, rows);
    if (const long now = k % 256 == 0 ? std::time(nullptr) : shown; now - shown >= 2) {
      std::fprintf(stderr, "\r%s, %d wall%s: %ld %% ", name.c_str(), Walls, Walls == 1 ? "" : "s",
                   100 * k / count);
      shown = now;
    }
  }
  std::fprintf(stderr, "\r%40s\r", "");
  std::apply([&](auto&... row) { (row.print(name, laws.first), ...); }, rows);
}

// The mechanism under the laws of the paper, and, with its inertia, under the recommended one.
// saturated_direct_control takes one wall; of an arm with self-motion two walls take many minutes to compile.
template <class M, class WithInertia = M>
bool add(const std::string& name, const M& mechanism, const WithInertia& heavy) {
  const std::pair none("no_direct_control", ph::no_direct_control());
  const std::pair direct("direct_control", ph::direct_control());
  const std::pair saturated("saturated_direct_control", ph::saturated_direct_control());
  const std::pair velocity("velocity_direct_control", ph::velocity_direct_control());
  devices().push_back({name, [=](long count) {
                         print_rows<1>(name, mechanism, count, none, direct, saturated);
                         print_rows<1>(name, heavy, count, velocity);
                         if constexpr (M::dof == M::task_dimension) {
                           print_rows<2>(name, mechanism, count, none, direct);
                           print_rows<2>(name, heavy, count, velocity);
                         }
                       }});
  return true;
}
template <class M>
bool add(const std::string& name, const M& mechanism) {
  return add(name, mechanism, mechanism);
}

}  // namespace worst_case
