// Files that go with the test.
#pragma once

#include "mesh_formats.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace mesh_files {

namespace fs = std::filesystem;

struct in_a_folder : ::testing::Test {
  fs::path folder;

  in_a_folder() {
    std::string name = (fs::temp_directory_path() / "mesh_files_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no directory " + name);
    folder = name;
  }
  ~in_a_folder() override { fs::remove_all(folder); }

  fs::path write(const std::string& name, const std::string& bytes) const {
    fs::remove(folder / name);  // overwriting waits for the disk
    std::ofstream(folder / name, std::ios::binary) << bytes;
    return folder / name;
  }
  // What read(path) throws, behind "passive_haptics: mesh file PATH: ".
  template <class Read>
  std::string error_of(Read read, const fs::path& path) const {
    const std::string start = "passive_haptics: mesh file " + path.string() + ": ";
    try {
      read(path);
    } catch (const std::invalid_argument& error) {
      const std::string text = error.what();
      return text.starts_with(start) ? text.substr(start.size()) : "not so named: " + text;
    }
    return "none";
  }
};

}  // namespace mesh_files
