#include <log/live_stream.hpp>

#include <chrono>
#include <stdexcept>

namespace example {

paced_stream::paced_stream(int port) : off_(port == 0) {
  if (off_) return;
  if (const std::string error = stream_.open(port); !error.empty())
    throw std::runtime_error("UDP port " + std::to_string(port) + ": " + error);
  sender_ = std::thread([this] { send_all(); });
}

paced_stream::~paced_stream() {
  if (off_) return;
  {
    const std::lock_guard lock(mutex_);
    complete_ = true;
  }
  changed_.notify_one();
  sender_.join();
}

void paced_stream::send(double time, log_row& row) {
  if (off_) return;
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back({time, row.json()});
  }
  changed_.notify_one();
}

void paced_stream::send_all() {
  const auto start = std::chrono::steady_clock::now();
  for (;;) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return complete_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    const message next = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    std::this_thread::sleep_until(start + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                              std::chrono::duration<double>(next.time)));
    stream_.send(next.json);
  }
}

}  // namespace example
