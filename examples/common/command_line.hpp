/// Command lines of examples.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace example {

/// Options as `--option VALUE` or `--option=VALUE`. `--help` prints the text of examples/help/NAME.txt; an
/// error is reported in one line, with status 2. Wraps CLI11 in one compiled file, which saves compile time.
class command_line {
 public:
  /// name: as in ./examples/run; about: what the example does and writes. The constructor also opens closed
  /// standard descriptors, so call it before any file, thread or process; if that fails, the program ends
  /// with status 1. Ignores SIGPIPE and SIGXFSZ, so that a write to a pipe without a reader or beyond the
  /// file size limit fails instead of ending the program.
  command_line(const std::string& name, const std::string& about);
  ~command_line();

  /// Values hold their defaults; a missing option changes nothing.
  void flag(const std::string& option, bool& value, const std::string& about);
  /// A non-empty text; kind: name of the value, as FILE.
  void text(const std::string& option, std::string& value, const std::string& kind, const std::string& about);
  /// One of these words.
  void choice(const std::string& option, std::string& value, const std::vector<std::string>& words,
              const std::string& about);
  /// A finite number > 0.
  void positive(const std::string& option, double& value, const std::string& about);
  /// A UDP port, 1 to 65535.
  void port(const std::string& option, int& value, const std::string& about);
  /// `--output DIR`, the directory of the example's files; the last one counts. parse() creates it.
  void output(std::filesystem::path& directory);
  /// Text of `--help` below the options.
  void notes(const std::string& text);

  /// Ends the program for --help with status 0, for an error with 2, without the directory with 1. At its
  /// end, output without room is reported, with status 1.
  void parse(int argc, char** argv);

 private:
  struct options;
  std::unique_ptr<options> all_;
};

/// The directory for an example with the single option `--output DIR`.
std::filesystem::path output_directory(int argc, char** argv, const std::string& name,
                                       const std::string& about);

}  // namespace example
