/// @file
/// The command line of an example.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace example {

/// Options as `--option VALUE` or `--option=VALUE`. `--help` prints examples/help/NAME.txt's text; a mistake
/// is reported in one line, with status 2. (CLI11 does it, behind one compiled file: it costs 2 s of the
/// compiler.)
class command_line {
 public:
  /// name: as ./examples/run has it; about: what the example does and what it leaves. The constructor also
  /// opens the standard descriptors that are closed, so make it before any file, thread or process; where it
  /// cannot, the program ends with status 1. It ignores SIGPIPE and SIGXFSZ: a write to a pipe that nobody
  /// reads, or beyond the limit of a file's size, fails and does not end the program.
  command_line(const std::string& name, const std::string& about);
  ~command_line();

  /// Values hold their defaults; an option that is not there changes nothing.
  void flag(const std::string& option, bool& value, const std::string& about);
  /// A text that is not empty; kind: what it is, as FILE.
  void text(const std::string& option, std::string& value, const std::string& kind, const std::string& about);
  /// One of these words.
  void choice(const std::string& option, std::string& value, const std::vector<std::string>& words,
              const std::string& about);
  /// A finite number > 0.
  void positive(const std::string& option, double& value, const std::string& about);
  /// A whole number from 0 on, of at most 18 digits.
  void whole_number(const std::string& option, std::optional<std::uint64_t>& value, const std::string& about);
  /// The names of one or more files, up to the next option.
  void files(const std::string& option, std::vector<std::string>& values, const std::string& about);
  /// A UDP port, 1 to 65535.
  void port(const std::string& option, int& value, const std::string& about);
  /// `--output DIR`, where the example's files go; the last one counts. parse() makes it.
  void output(std::filesystem::path& directory);
  /// What `--help` says below the options.
  void notes(const std::string& text);

  /// Ends the program for --help with status 0, for a mistake with 2, for no directory with 1. At its end
  /// output that found no room is reported, with status 1.
  void parse(int argc, char** argv);

 private:
  struct options;
  std::unique_ptr<options> all_;
};

/// The directory of an example whose only option is `--output DIR`.
std::filesystem::path output_directory(int argc, char** argv, const std::string& name,
                                       const std::string& about);

}  // namespace example
