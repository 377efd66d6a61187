// Numbered experiments, which can be split over several machines and merged.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace experiments {

// Numbers of experiments, inclusive. Number k is random plant k / 18 (plants.hpp) along one of three walls,
// with an environment at 1 kHz or 20 Hz, under one of three laws.
struct number_range {
  std::uint64_t first, last;
};

inline constexpr std::uint64_t max_of_a_part = 1'000'000;  // their results are kept in memory

// Error text of a range, empty if there is none.
std::string range_error(number_range which);

// File name of a part: experiments_0_99.csv.
std::string file_name(number_range which);

// Runs them on all processors; returns a header and one line each, in order.
std::string run_by_number(number_range which);

// A file of run_by_number.
struct part_file {
  std::string name, content;
};

// The result of run_by_number for the whole range, from files with each experiment once, in any order. Throws
// std::invalid_argument with the file or the experiments for other files.
std::string merged(const std::vector<part_file>& parts, number_range which);

}  // namespace experiments
