/// Closing of inherited files in a forked process.
#pragma once

#include <passive_haptics/driver/process/failed_call.hpp>

#include <dirent.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <string>
#include <vector>

namespace passive_haptics::detail {

using kept_files = std::array<int, 2>;

inline void close_unless_kept(int file, const kept_files& kept) noexcept {
  if (file > STDERR_FILENO && std::find(kept.begin(), kept.end(), file) == kept.end()) close(file);
}

// False, with errno, if the call is unavailable (Linux before 5.9) or filtered
inline bool close_ranges(kept_files kept) noexcept {
  std::sort(kept.begin(), kept.end());
  unsigned from = STDERR_FILENO + 1;
  for (const int file : kept) {
    const auto number = static_cast<unsigned>(file);
    if (number < from) continue;
    if (number > from && close_range(from, number - 1, 0) != 0) return false;
    from = number + 1;
  }
  return close_range(from, ~0U, 0) == 0;
}

// False if the list cannot be read completely
inline bool close_listed(const kept_files& kept) {
  DIR* const list = opendir("/proc/self/fd");
  if (list == nullptr) return false;
  std::vector<int> files;  // collected first, because closing changes the list
  errno = 0;
  while (const dirent* const entry = readdir(list)) files.push_back(std::atoi(entry->d_name));  // "." is 0
  const bool whole = errno == 0;
  closedir(list);  // its number is in the list, too
  if (whole)
    for (const int file : files) close_unless_kept(file, kept);
  return whole;
}

// Closes up to this limit; false if that is too many: some containers have 1e9
inline bool close_up_to(rlim_t limit, const kept_files& kept) noexcept {
  constexpr rlim_t max_files = 1 << 20;  // fs.nr_open of Linux; less than a second
  if (limit > max_files) return false;
  for (int file = 0; file < static_cast<int>(limit); ++file) close_unless_kept(file, kept);
  return true;
}

// Closes all except the standard descriptors and these; returns an error or an empty string
inline std::string close_all_but(const kept_files& kept) {
  if (close_ranges(kept)) return {};
  const int why = errno;
  rlimit limit{};
  if (close_listed(kept)) return {};
  if (getrlimit(RLIMIT_NOFILE, &limit) == 0 && close_up_to(limit.rlim_cur, kept)) return {};
  errno = why;
  return failed_call("close_range",
                     "allow it if system calls are filtered, mount /proc, or set `ulimit -n 4096`");
}

}  // namespace passive_haptics::detail
