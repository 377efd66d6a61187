// The example experiments with its options for parts alone: it is compiled in a tenth of the time.
#include <experiments/numbered_options.hpp>

#include <cstdio>
#include <exception>
#include <filesystem>

int main(int argc, char** argv) try {
  std::filesystem::path directory = ".";
  experiments::numbered_options numbered;
  example::command_line line("experiments", "Parts of the experiments.");
  numbered.add_to(line);
  line.output(directory);
  line.parse(argc, argv);
  numbered.carry_out(directory);
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
