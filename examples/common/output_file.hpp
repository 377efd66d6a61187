/// Files that are written whole or not at all.
#pragma once

#include <passive_haptics/scene/files/file_kind.hpp>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <utility>

namespace example {

/// Treatment of a FILE.part of a program that ended early.
enum class leftover {
  refuse,  ///< It may contain a measurement.
  replace  ///< Its content can be computed again.
};

/// Writes to FILE.part, which commit() renames to FILE. FILE.part is exclusive. FILE may be a regular file,
/// which is replaced, a link to one, or missing; a device, FIFO, socket or directory is rejected. Errors are
/// std::runtime_error with path, expectation and remedy.
class output_file {
 public:
  explicit output_file(const std::filesystem::path& path, leftover left = leftover::refuse)
      : path_(place_of(path)),
        part_(path_.string() + ".part"),
        descriptor_(open_part(left)),
        buffer_(descriptor_) {}
  output_file(const output_file&) = delete;
  output_file& operator=(const output_file&) = delete;
  /// Removes FILE.part, unless keep() was called.
  ~output_file() {
    if (descriptor_ < 0) return;
    stream_.flush();
    close(descriptor_);
    if (!kept_) unlink(part_.c_str());
  }

  std::ostream& stream() { return stream_; }
  /// Keeps the data in FILE.part if commit() is not reached or fails.
  void keep() { kept_ = true; }
  /// Reason of a failed write, "No space left on device"; empty if there is none.
  std::string error() const { return buffer_.error == 0 ? "" : std::strerror(buffer_.error); }
  /// True if FILE.part was removed: the data is lost.
  bool is_removed() const {
    struct stat file{};
    return fstat(descriptor_, &file) == 0 && file.st_nlink == 0;
  }

  /// Writes all data to the disk and renames it to FILE.
  void commit() {
    stream_.flush();
    if (buffer_.error == 0 && fsync(descriptor_) != 0) buffer_.error = errno;
    if (is_removed())
      throw std::runtime_error("cannot write '" + part_ +
                               "': it was removed: expected it to stay until it is complete");
    if (buffer_.error != 0)
      throw std::runtime_error("cannot write all of '" + part_ + "': " + error() +
                               ": expected room for it; make room, or choose another folder");
    place_of(path_);  // may have changed
    if (rename(part_.c_str(), path_.c_str()) != 0) fail(path_.string(), errno);
    close(std::exchange(descriptor_, -1));
  }

 private:
  // Buffer of a descriptor; stores the first error.
  class descriptor_buffer : public std::streambuf {
   public:
    explicit descriptor_buffer(int to) : to_(to) { setp(bytes_.data(), bytes_.data() + bytes_.size()); }
    int error = 0;

   protected:
    int_type overflow(int_type c) override {
      if (sync() != 0) return traits_type::eof();
      if (!traits_type::eq_int_type(c, traits_type::eof())) sputc(traits_type::to_char_type(c));
      return traits_type::not_eof(c);
    }
    int sync() override {
      const char* from = pbase();
      while (error == 0 && from < pptr()) {
        const ssize_t size = write(to_, from, static_cast<std::size_t>(pptr() - from));
        if (size >= 0) from += size;
        else if (errno != EINTR) error = errno;
      }
      setp(bytes_.data(), bytes_.data() + bytes_.size());
      return error == 0 ? 0 : -1;
    }

   private:
    int to_;
    std::array<char, 1 << 16> bytes_;
  };

  [[noreturn]] static void fail(const std::string& path, int error) {
    throw std::runtime_error("cannot write '" + path + "': " + std::strerror(error) +
                             ": expected a folder that is there and where you may write");
  }

  // The file instead of a link to it, which renaming would replace.
  static std::filesystem::path place_of(const std::filesystem::path& path) {
    const std::string kind = passive_haptics::file_kind(path);
    if (kind == "a regular file") return std::filesystem::canonical(path);
    if (kind == "nothing" && path.has_filename()) return path;
    throw std::runtime_error("cannot write '" + path.string() + "': it is " + kind +
                             ": expected a regular file or a free name; choose another name");
  }

  int open_part(leftover left) const {
    const auto create = [&] { return open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666); };
    int file = create();
    if (file < 0 && errno == EEXIST) {
      const pid_t writer = writer_of_part();
      if (writer != 0 || left == leftover::refuse || passive_haptics::file_kind(part_) != "a regular file")
        throw std::runtime_error("cannot write '" + part_ + "': it is there, " + owner_of_part(writer));
      unlink(part_.c_str());
      file = create();
    }
    if (file < 0) fail(part_, errno);
    struct flock all{};
    all.l_type = F_WRLCK;
    fcntl(file, F_SETLK, &all);  // only shows the writer
    return file;
  }

  // Process that has locked the file; 0 for none.
  pid_t writer_of_part() const {
    struct flock all{};
    all.l_type = F_WRLCK;
    const int file = open(part_.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    const bool known = file >= 0 && fcntl(file, F_GETLK, &all) == 0 && all.l_type != F_UNLCK;
    if (file >= 0) close(file);
    return known ? all.l_pid : 0;
  }
  static std::string owner_of_part(pid_t writer) {
    if (writer != 0)
      return "and process " + std::to_string(writer) +
             " writes to it; wait until that ends, or choose another name";
    return "left by a program that ended early; keep what you need of it, then remove it";
  }

  std::filesystem::path path_;
  std::string part_;
  int descriptor_;
  descriptor_buffer buffer_;
  std::ostream stream_{&buffer_};
  bool kept_ = false;
};

}  // namespace example
