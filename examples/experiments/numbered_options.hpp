// The options --first, --last and --merge of a program.
#pragma once

#include "numbered.hpp"

#include <command_line.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace experiments {

class numbered_options {
 public:
  void add_to(example::command_line& line);
  bool are_given() const { return first_ || last_ || !parts_.empty(); }
  // Runs the experiments, or merges their files, into one file in this directory. Throws
  // std::invalid_argument.
  void carry_out(const std::filesystem::path& directory) const;
  // Throws std::invalid_argument for a missing or incomplete range.
  number_range range() const;

 private:
  std::optional<std::uint64_t> first_, last_;
  std::vector<std::string> parts_;
};

}  // namespace experiments
