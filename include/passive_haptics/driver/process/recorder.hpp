/// @file
/// A second process that writes down what the loop says, also when the loop's process dies.
#pragma once

#include <passive_haptics/driver/process/child_process.hpp>
#include <passive_haptics/driver/process/shared_memory.hpp>
#include <passive_haptics/driver/process/shared_ring.hpp>

#include <atomic>
#include <concepts>
#include <cstdint>
#include <string>
#include <utility>

namespace passive_haptics {

/// Where records go, in the recorder's process. open(): empty, or what is wrong; take(record): each, in
/// order; rest(missing): some times a second, for what need not be done for each; missing is how many records
/// did not fit so far; close(): after the last one. An exception ends the process, with its text on stderr.
///
/// A sink that cannot keep all it takes, as on a full disk, also has `std::uint64_t lost() const`, how many
/// of them so far; it is called after rest().
template <class S, class Record>
concept RecordSink = requires(S sink, const Record& record) {
  { sink.open() } -> std::same_as<std::string>;
  sink.take(record);
  sink.rest(std::uint64_t{});
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
  bool operator()(const Record& record) noexcept { return shared_->ring.push(record); }

  /// How many records did not fit or could not be kept; after stop() also those that the process took with
  /// it.
  std::uint64_t lost() const noexcept {
    const std::uint64_t gone = ended_ ? shared_->ring.pushed() - shared_->kept : shared_->not_kept.load();
    return shared_->ring.lost() + gone;
  }
  /// Waits until all is written, at most ten seconds and one more (child_process::stop()). False if the
  /// process was not there any more, did not come to an end or its sink threw.
  bool stop() noexcept {
    ended_ = true;
    return child_.stop();
  }
  /// Its process number; <= 0 if it does not run.
  pid_t pid() const noexcept { return child_.pid(); }

 private:
  static constexpr double pause = 0.02;  // [s]

  void write_down(parent_link parent) {
    Record record;
    std::uint64_t taken = 0;
    for (bool last = false; !last;) {
      last = parent.gone_within(pause);  // before the queue is emptied: then nothing can come after it
      for (; shared_->ring.pop(record); ++taken) sink_.take(record);
      sink_.rest(shared_->ring.lost());
      std::uint64_t not_kept = 0;
      if constexpr (requires { sink_.lost(); }) not_kept = sink_.lost();
      shared_->not_kept = not_kept;
      shared_->kept = taken - not_kept;
    }
    sink_.close();
  }

  struct shared {
    shared_ring<Record, Capacity> ring;
    std::atomic<std::uint64_t> kept = 0, not_kept = 0;  // of the records that were taken
  };

  Sink sink_;
  shared_memory<shared> shared_;
  child_process child_;
  bool ended_ = false;
};

}  // namespace passive_haptics
