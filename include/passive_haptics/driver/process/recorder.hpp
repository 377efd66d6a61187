/// @file
/// A second process that writes down what the loop says, also when the loop's process dies.
#pragma once

#include <passive_haptics/driver/process/child_process.hpp>
#include <passive_haptics/driver/process/shared_memory.hpp>
#include <passive_haptics/driver/process/shared_ring.hpp>

#include <concepts>
#include <cstdint>
#include <string>
#include <utility>

namespace passive_haptics {

/// Where records go, in the recorder's process. open(): empty, or what is wrong; take(record): each, in
/// order; rest(): some times a second, for what need not be done for each; close(): after the last one. What
/// it throws ends the process, with its text on stderr.
template <class S, class Record>
concept RecordSink = requires(S sink, const Record& record) {
  { sink.open() } -> std::same_as<std::string>;
  sink.take(record);
  sink.rest();
  sink.close();
};

/// Takes records from the loop without ever letting it wait for a disk or a terminal. They stand in memory
/// that both processes share: what was recorded before the loop's process died, by whatever signal, is
/// written all the same.
///
/// Start it before the loop's real-time set-up and before any thread. At 1 kHz 8192 records last 8 s.
template <class Record, RecordSink<Record> Sink, std::size_t Capacity = 8192>
class recorder {
 public:
  /// The sink is opened in the other process.
  explicit recorder(Sink sink) : sink_(std::move(sink)) {}

  /// Forks the process, which opens its sink; empty, or why it could not.
  std::string start() {
    return child_.start([this] { return sink_.open(); }, [this](parent_link parent) { write_down(parent); });
  }

  /// Records; false, and counted, where the other process is so far behind that it did not fit. Wait-free.
  bool operator()(const Record& record) noexcept { return ring_->push(record); }

  /// How many records did not fit, and after stop() also those that nobody was there any more to take.
  std::uint64_t lost() const noexcept { return ring_->lost() + (ended_ ? ring_->size() : 0); }
  /// Waits until all is written. False if the process was not there any more or its sink threw.
  bool stop() noexcept {
    ended_ = true;
    return child_.stop();
  }
  /// Its process number; <= 0 if it does not run.
  pid_t pid() const noexcept { return child_.pid(); }

 private:
  static constexpr int pause = 20;  // [ms]

  void write_down(parent_link parent) {
    Record record;
    for (bool last = false; !last;) {
      last = parent.gone(pause);  // before the queue is emptied: then nothing can come after it
      while (ring_->pop(record)) sink_.take(record);
      sink_.rest();
    }
    sink_.close();
  }

  Sink sink_;
  shared_memory<shared_ring<Record, Capacity>> ring_;
  child_process child_;
  bool ended_ = false;
};

}  // namespace passive_haptics
