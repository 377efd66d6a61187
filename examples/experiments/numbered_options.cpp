#include "numbered_options.hpp"

#include <output.hpp>

#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace experiments {

namespace {

part_file read(const std::string& name) {
  std::ifstream file(name, std::ios::binary);
  std::ostringstream content;
  if (file) content << file.rdbuf();
  if (!file || file.bad() || std::filesystem::is_directory(name))
    throw std::invalid_argument("cannot read '" + name + "': expected a file of experiments; check its name");
  return {name, content.str()};
}

}  // namespace

void numbered_options::add_to(example::command_line& line) {
  line.whole_number("--first", first_,
                    "run only random plants and hands, from this number on (docs/guide/batch.md)");
  line.whole_number("--last", last_, "up to this number; writes one CSV file");
  line.files("--merge", parts_, "merge such files into the file that a single run would write");
}

number_range numbered_options::range() const {
  if (!first_ || !last_)
    throw std::invalid_argument(std::string(first_ ? "--last" : "--first") +
                                " is missing: expected both --first and --last; add it");
  const number_range which{*first_, *last_};
  if (const std::string error = range_error(which); !error.empty()) throw std::invalid_argument(error);
  return which;
}

void numbered_options::carry_out(const std::filesystem::path& directory) const {
  const number_range which = range();
  std::vector<part_file> parts;
  for (const std::string& name : parts_) parts.push_back(read(name));
  const std::filesystem::path file = directory / file_name(which);
  example::write_file(file, parts.empty() ? run_by_number(which) : merged(parts, which));
  std::printf("table:   %s\n", std::filesystem::weakly_canonical(file).c_str());
}

}  // namespace experiments
