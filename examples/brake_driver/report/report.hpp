/// @file
/// Who writes down what the loop says of each cycle.
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

/// A RecordSink: a log and a device file of its device, whole or not at all, the same log as a stream for who
/// draws it, and a table in the terminal; what is lost, as it happens. Lives in the recorder's process. A
/// terminal or a pipe that nobody reads loses tables; the files go on.
class report_sink {
 public:
  /// Nothing is shown without `live`, no file is written without a name, nothing sent without a port.
  report_sink(const session_options& options, const configuration& c);

  std::string open();
  void take(const record& r);
  /// `missing`: records that never came here.
  void rest(std::uint64_t missing);
  /// Of those that came, how many are not in the file.
  std::uint64_t lost() const { return lost_; }
  /// Throws std::runtime_error where the file is not whole: what there is stays in FILE.part.
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
  double shown_ = -1;  // time of the last record that was shown [s]
  int lines_ = 0;      // of the table on the terminal,
  winsize size_{};     // which had this size then
  int output_ = -1;
  std::string pending_;  // what is shown but had no room yet
  ph::duration_histogram late_, compute_;
};

/// A histogram as lines of a table, durations by powers of two.
std::string bars(const ph::duration_histogram& h);

/// "12 us" or "1.3 ms".
std::string duration(double nanoseconds);

}  // namespace example
