/// A process that stores the loop's records, even if the loop's process dies.
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

/// Destination of records in the recorder's process. open(): returns an error or an empty string;
/// take(record): each record in order; rest(missing): some times per second, with the number of lost records;
/// close(): after the last record. Optional: `std::uint64_t lost() const`, the number of records that could
/// not be stored. An exception ends the process, with its text on stderr.
template <class S, class Record>
concept RecordSink = requires(S sink, const Record& record) {
  { sink.open() } -> std::same_as<std::string>;
  sink.take(record);
  sink.rest(std::uint64_t{});
  sink.close();
};

/// Accepts records from the loop without waiting, in memory shared by both processes, so records before the
/// death of the loop's process are stored. Start it before the loop's real-time set-up and before any thread.
/// At 1 kHz 8192 records last 8 s.
template <class Record, RecordSink<Record> Sink, std::size_t Capacity = 8192>
class recorder {
 public:
  explicit recorder(Sink sink) : sink_(std::move(sink)) {}  ///< The sink is opened in the other process.

  /// Forks the process, which opens its sink. Returns an error or an empty string.
  std::string start() {
    return child_.start([this] { return sink_.open(); }, [this](parent_link parent) { write_down(parent); });
  }

  /// Adds a record. Returns false and counts it if the queue is full. Wait-free.
  bool operator()(const Record& record) noexcept { return shared_->ring.push(record); }

  /// Number of lost records; after stop() also those lost with the process.
  std::uint64_t lost() const noexcept {
    const std::uint64_t gone = ended_ ? shared_->ring.pushed() - shared_->kept : shared_->not_kept.load();
    return shared_->ring.lost() + gone;
  }
  /// Waits until all is written, at most eleven seconds (child_process::stop()). Returns false if the process
  /// had died, did not end or its sink threw.
  bool stop() noexcept {
    ended_ = true;
    return child_.stop();
  }
  pid_t pid() const noexcept { return child_.pid(); }  ///< Process number; <= 0 if it does not run.

 private:
  static constexpr double pause = 0.02;  // [s]

  void write_down(parent_link parent) {
    Record record;
    std::uint64_t taken = 0;
    for (bool last = false; !last;) {
      last = parent.gone_within(pause);  // before the queue is emptied, so that no record can follow
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
    std::atomic<std::uint64_t> kept = 0, not_kept = 0;  // of the records taken
  };

  Sink sink_;
  shared_memory<shared> shared_;
  child_process child_;
  bool ended_ = false;
};

}  // namespace passive_haptics
