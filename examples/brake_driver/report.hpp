/// @file
/// What the loop says of each cycle, and who writes it down.
#pragma once

#include <configuration.hpp>

#include <passive_haptics/driver/duration_histogram.hpp>

#include <cstdint>
#include <cstdio>
#include <string>

namespace example {

/// What the driver is doing.
enum class phase : std::uint8_t { homing, taring, running };

/// A cycle, as a value that processes can hand over.
struct record {
  double time = 0;          ///< [s], since the loop began.
  std::int64_t number = 0;  ///< Of the period.
  example::phase phase = phase::homing;
  ph::port_state state = ph::port_state::ready;
  ph::incident reason;   ///< Why the brakes are released.
  ph::incident bridged;  ///< What is wrong with the last samples.
  ph::status outcome = ph::status::ok;
  ph::power_class power = ph::power_class::none;
  ph::display_class display = ph::display_class::exact;
  double gamma = 0, alpha = 1;          ///< [rad], [1]
  std::array<double, axes> q{}, qd{};   ///< [rad or m], and of it a second
  std::array<double, 2> x{};            ///< Handle [m].
  std::array<double, 2> hand{};         ///< Force of the hand [N].
  std::array<double, 2> desired{};      ///< Force that the walls ask for [N].
  std::array<double, axes> capacity{};  ///< What each brake may hold [N m].
  std::array<double, axes> current{};   ///< What each brake gets [A].
  double late = 0, compute = 0;         ///< [s]
};

/// A RecordSink: a CSV file, whole or not at all, and a table in the terminal. Lives in the recorder's process.
class report_sink {
 public:
  /// Nothing is shown without `live`, no file is written without a name.
  report_sink(std::string file, bool live, const configuration& c);

  std::string open();
  void take(const record& r);
  void rest();
  void close();

 private:
  void show();

  std::string file_, part_, title_;
  bool live_, terminal_ = false;
  std::array<double, axes> current_limit_{};
  std::FILE* out_ = nullptr;
  record last_;
  std::uint64_t count_ = 0;
  double shown_ = -1;  // time of the last record that was shown [s]
  int lines_ = 0;      // of the table on the terminal
  ph::duration_histogram late_, compute_;
};

/// A histogram as lines of a table, durations by powers of two.
std::string bars(const ph::duration_histogram& h);

/// "12 us" or "1.3 ms".
std::string duration(double nanoseconds);

}  // namespace example
