/// Storage and display of the loop's records.
#pragma once

#include <configuration/configuration.hpp>
#include <log/decision.hpp>
#include <log/live_stream.hpp>
#include <output_file.hpp>
#include <report/record.hpp>
#include <session.hpp>

#include <passive_haptics/driver/duration_histogram.hpp>

#include <sys/ioctl.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace example {

/// A RecordSink: writes a log and its device file (whole or not at all), streams the log for display, and
/// shows a table in the terminal, including losses. Runs in the recorder's process. A terminal or pipe
/// without a reader loses tables; the files continue.
class report_sink {
 public:
  /// No display without `live`, no file without a name, no stream without a port.
  report_sink(const session_options& options, const configuration& c);

  std::string open();
  void take(const record& r);
  /// `missing`: lost records before this sink.
  void rest(std::uint64_t missing);
  /// Number of received records that are not in the file.
  std::uint64_t lost() const { return lost_; }
  /// Throws std::runtime_error if the file is incomplete; the data stays in FILE.part.
  void close();

 private:
  void show();
  void write_shown();
  std::string loss() const;

  std::string name_, title_;
  bool live_, terminal_ = false;
  int live_port_;
  joint_kinds joints_;
  log_row row_;
  live_stream stream_;
  ph::brake_curves<max_axes> curves_;
  std::string device_text_;
  std::unique_ptr<output_file> file_, device_file_;
  record blank_, last_;
  std::uint64_t count_ = 0, kept_ = 0, lost_ = 0, missing_ = 0;
  double shown_ = -1;  // time of the last displayed record [s]
  int lines_ = 0;      // of the table on the terminal
  winsize size_{};     // its size at that time
  int output_ = -1;
  std::string pending_;  // output that had no room yet
  ph::duration_histogram late_, compute_;
};

/// A histogram as lines of a table, durations by powers of two.
std::string bars(const ph::duration_histogram& h);

/// "12 us" or "1.3 ms".
std::string duration(double nanoseconds);

}  // namespace example
