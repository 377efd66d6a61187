#include <command_line.hpp>

#include <passive_haptics/core/text.hpp>
#include <passive_haptics/driver/process/standard_descriptors.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>

namespace example {
namespace {

[[noreturn]] void fail(const std::string& message, int status) {
  std::cerr << "error: " << message << "\n";
  std::exit(status);
}

// At the end of the program: reports output that did not fit on the disk.
void tell_of_a_full_disk() {
  if (std::fflush(stdout) == 0 || (errno != ENOSPC && errno != EDQUOT && errno != EFBIG)) return;
  std::fprintf(stderr, "error: cannot write all of the output: %s\n", std::strerror(errno));
  std::_Exit(1);
}

// Validators of CLI11: an error text, or empty.
std::string not_empty(const std::string& text) { return text.empty() ? "empty: expected a value" : ""; }

auto number_that(bool (*is_right)(double), const char* expected) {
  return [=](const std::string& text) {
    double value = 0;
    const bool right = CLI::detail::lexical_cast(text, value) && std::isfinite(value) && is_right(value);
    return right ? std::string() : text + ": expected " + expected;
  };
}

}  // namespace

struct command_line::options : CLI::App {
  using CLI::App::App;
  std::filesystem::path* output = nullptr;

  template <class T>
  CLI::Option* add(const std::string& name, T& value, const std::string& kind, const std::string& about) {
    return add_option(name, value, about)->type_name(kind);
  }
};

command_line::command_line(const std::string& name, const std::string& about)
    : all_(std::make_unique<options>(about, name)) {
  if (!passive_haptics::open_standard_descriptors())
    fail(std::string("/dev/null: ") + std::strerror(errno) +
             ": expected it instead of a closed descriptor; start the program with descriptors 0 to 2 open",
         1);
  // A failing write must neither end the program nor change its exit status
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
  all_->set_help_flag("--help,-h", "this text");
  all_->get_formatter()->column_width(24);
}
command_line::~command_line() = default;

void command_line::flag(const std::string& option, bool& value, const std::string& about) {
  all_->add_flag(option, value, about)->disable_flag_override();
}

void command_line::text(const std::string& option, std::string& value, const std::string& kind,
                        const std::string& about) {
  all_->add(option, value, kind, about)->default_str(value)->check(not_empty);
}

void command_line::choice(const std::string& option, std::string& value,
                          const std::vector<std::string>& words, const std::string& about) {
  std::string list;
  for (const auto& word : words) list += (list.empty() ? "" : ", ") + word;
  const auto known = [=](const std::string& text) {
    const bool found = std::find(words.begin(), words.end(), text) != words.end();
    return found ? std::string() : "'" + text + "': expected one of " + list;
  };
  all_->add(option, value, "NAME", about + ":\n" + list)->default_str(value)->check(known);
}

void command_line::positive(const std::string& option, double& value, const std::string& about) {
  auto* added = all_->add(option, value, "NUMBER", about)
                    ->check(number_that([](double x) { return x > 0; }, "a number > 0"));
  if (std::isfinite(value)) added->default_str(passive_haptics::detail::number_text(value));
}

void command_line::port(const std::string& option, int& value, const std::string& about) {
  all_->add(option, value, "PORT", about)
      ->check(number_that([](double x) { return x >= 1 && x <= 65535 && x == std::floor(x); },
                          "a port, 1 to 65535"));
}

void command_line::output(std::filesystem::path& directory) {
  all_->output = &directory;
  all_->add("--output", directory, "DIR",
            "directory of the files; created if it does not exist (default: here)")
      ->take_last()
      ->check(not_empty);
}

void command_line::notes(const std::string& text) { all_->footer(text); }

void command_line::parse(int argc, char** argv) {
  std::atexit(tell_of_a_full_disk);
  try {
    all_->parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    std::cout << all_->help();
    std::exit(0);
  } catch (const CLI::ParseError& error) {
    fail(error.what() + std::string("; --help lists the options"), 2);
  }
  if (all_->output == nullptr) return;
  std::error_code error;
  std::filesystem::create_directories(*all_->output, error);
  if (error) fail("cannot make the directory '" + all_->output->string() + "': " + error.message(), 1);
}

std::filesystem::path output_directory(int argc, char** argv, const std::string& name,
                                       const std::string& about) {
  std::filesystem::path directory = ".";
  command_line line(name, about);
  line.output(directory);
  line.parse(argc, argv);
  return directory;
}

}  // namespace example
