// Files that go with the test, and readers of them.
#pragma once

#include "mesh_formats.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace mesh_files {

namespace fs = std::filesystem;

using reader = std::function<ph::mesh_file(const fs::path&)>;
inline const reader stl = [](const fs::path& p) { return ph::read_stl(p); },
                    obj_file = [](const fs::path& p) { return ph::read_obj(p); },
                    ply = [](const fs::path& p) { return ph::read_ply(p); };

struct format {
  const char* name;
  reader read;
  std::string cube;
};
inline std::vector<format> text_formats() {
  return {{"ascii.stl", stl, ascii_stl(cube())},
          {"cube.obj", obj_file, obj(cube())},
          {"ascii.ply", ply, ascii_ply(cube())}};
}
inline std::vector<format> formats() {
  auto all = text_formats();
  all.push_back({"binary.stl", stl, binary_stl(cube())});
  all.push_back({"little.ply", ply, binary_ply(cube())});
  all.push_back({"big.ply", ply, binary_ply(cube(), std::endian::big)});
  return all;
}

inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

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
  ph::mesh_file obj_of(const std::string& text) const { return ph::read_obj(write("a.obj", text)); }
  std::string obj_error(const std::string& text) const { return error_of(obj_file, write("a.obj", text)); }
  std::string stl_error(const std::string& text) const { return error_of(stl, write("a.stl", text)); }
  std::string ply_error(const std::string& text) const { return error_of(ply, write("a.ply", text)); }
  // The cube as it was written, nothing turned or lost.
  void expect_cube(const ph::mesh_file& file, const std::string& about) const {
    const mesh all = cube();
    ASSERT_EQ(file.mesh.facets.size(), all.facets.size()) << about;
    for (std::size_t f = 0; f < all.facets.size(); ++f)
      EXPECT_EQ(file.mesh.corners(f), all.corners(f)) << about << ", facet " << f;
    EXPECT_EQ(file.slivers + file.not_triangles + file.twisted_quads, 0) << about;
  }
};

}  // namespace mesh_files
