// libFuzzer: the bytes of a mesh file, behind one that chooses its format. A mesh that is read is valid, and
// no larger than its file; written down in any format it reads back as the same mesh. What is refused is
// named with the file, what stands there and what was expected.
#include "../unit/files/mesh_formats.hpp"
#include "memory_file.hpp"

#include <passive_haptics/scene/mesh/mesh_surface.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

namespace {

namespace ph = passive_haptics;
using fuzz::require;
using reader = ph::mesh_file (*)(const std::filesystem::path&, double);

constexpr std::array<reader, 3> readers{ph::read_stl, ph::read_obj, ph::read_ply};
enum : std::uint8_t { in_stl, in_obj, in_ply };

bool same(const mesh_files::mesh& a, const mesh_files::mesh& b) {
  return a.vertices == b.vertices && a.facets == b.facets;
}

void check(const ph::mesh_file& file, std::size_t bytes) {
  const auto& m = file.mesh;
  const std::string error = validate(m);
  require(error.empty(), "a mesh that is not valid was read", error);
  const bool is_all = file.slivers == 0 && file.not_triangles == 0 && file.twisted_quads == 0 &&
                      file.skipped_lines == 0 && file.skipped_bytes == 0;
  require(file.slivers >= 0 && file.not_triangles >= 0, "a negative number of what was left out");
  require(is_all == file.remarks.empty(), "something was left out without a remark", file.remarks);
  require(m.facets.size() <= bytes && m.vertices.size() <= 3 * m.facets.size(), "more than the file has");
  const ph::triangle_mesh made(m);  // which promises to take what is valid
  require(ph::all_finite(made.bounds().lower) && ph::all_finite(made.bounds().upper), "bounds without end");
  for (const auto& [format, text] : {std::pair{in_stl, mesh_files::ascii_stl(m)},
                                     {in_obj, mesh_files::obj(m)},
                                     {in_ply, mesh_files::ascii_ply(m)},
                                     {in_ply, mesh_files::binary_ply(m)},
                                     {in_ply, mesh_files::binary_ply(m, std::endian::big)}}) {
    const ph::mesh_file again = readers[format](fuzz::memory_file(text).path(), 1);
    require(same(again.mesh, m), "another mesh was read back", text);
    require(again.slivers == 0, "slivers were read back", text);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::reader in(data, size);
  const reader read = readers[in.byte() % readers.size()];
  const std::string bytes = in.text();
  const fuzz::memory_file file(bytes);
  try {
    check(read(file.path(), 1), bytes.size());
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    require(text.starts_with("passive_haptics: mesh file " + file.path() + ": "), "an error without the file",
            text);
    require(fuzz::has(text, ": expected ") || text.ends_with("; the file is damaged"), "nothing was expected",
            text);
    fuzz::require_readable(text);
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

// Of nothing it makes a cube in one of the formats; else mutates bytes as usual.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
  using namespace mesh_files;
  static const std::array<std::pair<std::uint8_t, std::string>, 6> cubes{
      {{in_stl, ascii_stl(cube())},
       {in_stl, binary_stl(cube())},
       {in_obj, mesh_files::obj(cube())},
       {in_ply, ascii_ply(cube())},
       {in_ply, binary_ply(cube())},
       {in_ply, binary_ply(cube(), std::endian::big)}}};
  if (size > 2) return LLVMFuzzerMutate(data, size, most);
  const auto& [format, text] = cubes[seed % cubes.size()];
  const std::size_t length = std::min(text.size(), most - 1);
  data[0] = format;
  std::memcpy(data + 1, text.data(), length);
  return 1 + length;
}
