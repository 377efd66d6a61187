// The parts of benchmark_scenes. Each registers its rows, and prints its table of those that ran.
#pragma once

#include <results.hpp>

#include <string>

namespace scenes {

inline constexpr unsigned seed = 20040627;

void add_ladder();
void add_large_scenes();

// Each returns its part of the summary, empty if some rows were filtered out.
std::string print_ladder(const benchmarks::results& all);
std::string print_large_scenes(const benchmarks::results& all);

}  // namespace scenes
