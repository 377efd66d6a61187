/// Output files of examples: whole or not at all.
#pragma once

#include <output_file.hpp>
#include <shell_quotes.hpp>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

namespace example {

/// Writes `path` with this content, or keeps the old file and throws std::runtime_error.
inline void write_file(const std::filesystem::path& path, const std::string& content) {
  output_file file(path, leftover::replace);
  file.stream() << content;
  file.commit();
}

/// Runs a gnuplot script for a picture `name`.svg; the variable `output` is the file to write. If gnuplot is
/// missing or fails, reports it: script and data remain for another machine.
inline void draw(const std::filesystem::path& directory, const std::string& name, const std::string& script) {
  write_file(directory / (name + ".gp"), "if (!exists('output')) output = '" + name + ".svg'\n" + script);
  const std::filesystem::path picture = directory / (name + ".svg");
  if (std::system("command -v gnuplot >/dev/null 2>&1") != 0) {
    std::cout << "no picture (gnuplot is not installed): run gnuplot on "
              << (directory / (name + ".gp")).string() << "\n";
    return;
  }
  // Through us, because gnuplot does not report a full disk. The path is absolute, because `cd -` and, with
  // CDPATH, `cd folder` go elsewhere
  const std::string run = "cd " + in_shell_quotes(std::filesystem::absolute(directory).string()) +
                          " && gnuplot -d -e \"output='/dev/stdout'\" " + in_shell_quotes(name + ".gp");
  output_file file(picture, leftover::replace);
  FILE* drawn = popen(run.c_str(), "r");
  std::array<char, 4096> bytes;
  for (std::size_t n; drawn != nullptr && (n = fread(bytes.data(), 1, bytes.size(), drawn)) > 0;)
    file.stream().write(bytes.data(), static_cast<std::streamsize>(n));
  if (drawn == nullptr || pclose(drawn) != 0) {
    std::cout << "no picture: gnuplot failed on " << (directory / (name + ".gp")).string() << "\n";
  } else {
    file.commit();
    std::cout << "picture: " << std::filesystem::weakly_canonical(picture).string() << "\n";
  }
}

}  // namespace example
