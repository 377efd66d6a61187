// Experiments by number, as many as you like: parts of them run on several machines and are merged
// afterwards.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace experiments {

// Numbers of experiments; both ends count. Number k is random plant k / 18 (plants.hpp) along one of three
// walls, with an environment at 1 kHz or 20 Hz, under one of three laws.
struct number_range {
  std::uint64_t first, last;
};

inline constexpr std::uint64_t max_of_a_part = 1'000'000;  // their results are kept in memory

// What is wrong with a range; empty if nothing.
std::string range_error(number_range which);

// The file of a part: experiments_0_99.csv.
std::string file_name(number_range which);

// Runs them on all processors; a head and a line for each, in the order of their numbers.
std::string run_by_number(number_range which);

// A file that run_by_number filled.
struct part_file {
  std::string name, content;
};

// What run_by_number returns for the whole range, from files that hold each of its experiments once, in any
// order. Throws std::invalid_argument, whose message names the file or the experiments, where they do not.
std::string merged(const std::vector<part_file>& parts, number_range which);

}  // namespace experiments
