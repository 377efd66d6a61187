/// @file
/// Exceptions of a user's functions that are called within a control cycle, which cannot throw.
#pragma once

#include <exception>
#include <utility>

namespace passive_haptics_python {

/// Keeps the first exception of this thread while it lives. Without one of these exceptions go their way.
class deferred_error {
 public:
  /// Keeps exceptions from here on.
  deferred_error() : outer_(std::exchange(innermost_, this)) {}
  deferred_error(const deferred_error&) = delete;
  deferred_error& operator=(const deferred_error&) = delete;
  ~deferred_error() { innermost_ = outer_; }

  /// Throws what was kept.
  void rethrow() {
    if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
  }

  /// Whether an exception is kept, so that a function need not be called any more.
  static bool is_kept() { return innermost_ != nullptr && innermost_->error_ != nullptr; }
  /// Keeps the exception that is handled now, or throws it where none may be kept.
  static void keep() {
    if (innermost_ == nullptr) throw;
    innermost_->error_ = std::current_exception();
  }

 private:
  inline static thread_local deferred_error* innermost_ = nullptr;

  deferred_error* outer_;
  std::exception_ptr error_;
};

}  // namespace passive_haptics_python
