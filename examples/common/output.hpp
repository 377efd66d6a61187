/// @file
/// Where examples leave their files: whole or not at all.
#pragma once

#include <output_file.hpp>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <string_view>

namespace example {

/// The directory named by `--output DIR` (default: the current one), made if it is not there. `--help` prints
/// `help` and ends the program; anything else is named as a mistake and ends it with status 2.
inline std::filesystem::path output_directory(int argc, char** argv, std::string_view help) {
  std::filesystem::path directory = ".";
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--help" || argument == "-h") {
      std::cout << help << "\noptions:\n  --output DIR  where the files go (default: the current directory)\n"
                << "  --help        this text\n";
      std::exit(0);
    }
    if (argument != "--output" || i + 1 == argc) {
      const char* problem = argument == "--output" ? "a directory is missing after " : "unknown argument ";
      std::cerr << "error: " << problem << "'" << argument << "'; choices: --output DIR, --help\n";
      std::exit(2);
    }
    directory = argv[++i];
  }
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) {
    std::cerr << "error: cannot make the directory '" << directory.string() << "': " << error.message()
              << "\n";
    std::exit(1);
  }
  return directory;
}

/// Gives `path` this content, or leaves what was there and throws std::runtime_error.
inline void write_file(const std::filesystem::path& path, const std::string& content) {
  output_file file(path, leftover::replace);
  file.stream() << content;
  file.commit();
}

/// Runs a gnuplot script that ends in a picture `name`.svg; it finds the name to write to in the variable
/// `output`. Where gnuplot is missing or fails, says so: the script and its data are there for another
/// machine.
inline void draw(const std::filesystem::path& directory, const std::string& name, const std::string& script) {
  write_file(directory / (name + ".gp"), "if (!exists('output')) output = '" + name + ".svg'\n" + script);
  const std::filesystem::path picture = directory / (name + ".svg");
  const std::string run =
      "cd '" + directory.string() + "' && gnuplot -e \"output='" + name + ".svg.part'\" '" + name + ".gp'";
  output_file file(picture, leftover::replace);
  if (std::system("command -v gnuplot >/dev/null 2>&1") != 0) {
    std::cout << "no picture (gnuplot is not installed): run gnuplot on "
              << (directory / (name + ".gp")).string() << "\n";
  } else if (std::system(run.c_str()) != 0) {
    std::cout << "no picture: gnuplot failed on " << (directory / (name + ".gp")).string() << "\n";
  } else {
    file.commit();
    std::cout << "picture: " << std::filesystem::weakly_canonical(picture).string() << "\n";
  }
}

}  // namespace example
