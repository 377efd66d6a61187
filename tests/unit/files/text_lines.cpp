// Texts as other programs write them, of all formats; numbers in them.
#include "mesh_files.hpp"

#include <bit>
#include <charconv>

namespace {

using namespace mesh_files;

std::string in_capitals(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 32);
  return text;
}

struct a_text : in_a_folder {};

TEST_F(a_text, may_end_in_a_zero_byte_or_ctrl_z) {
  for (const auto& [name, read, text] : text_formats())
    for (const std::string& end : {std::string(1, '\0'), std::string("\x1a"), std::string("\x1a\x1a\r\n")}) {
      const auto file = read(write(name, text + end));
      expect_cube(file, name);
      EXPECT_EQ(file.skipped_bytes, end.size()) << name;
      EXPECT_EQ(file.remarks,
                "bytes behind the end of the data, skipped: " + std::to_string(end.size()) + "\n");
      expect_cube(read(write(name, text.substr(0, text.size() - 1) + end)), name);
      EXPECT_NE(error_of(read, write(name, text + end + "x\n")), "none") << name;
    }
}

// Zero bytes to the end of a block are what a lost write leaves: only a text with an end of its own is whole.
TEST_F(a_text, may_end_in_many_zero_bytes_if_it_is_whole_all_the_same) {
  const std::string zeros(512, '\0');
  for (const auto& [name, read, text] : text_formats()) {
    if (std::string(name) == "cube.obj") continue;
    const auto file = read(write(name, text + zeros));
    expect_cube(file, name);
    EXPECT_EQ(file.skipped_bytes, 512u) << name;
    EXPECT_NE(error_of(read, write(name, text.substr(0, text.size() - 30) + zeros)), "none") << name;
  }
  EXPECT_EQ(
      obj_error(obj(cube()) + zeros),
      "line 21: a zero byte or Ctrl-Z: expected text; lines may be lost here: if none is, remove such bytes");
}

TEST_F(a_text, may_begin_with_the_mark_of_utf_8) {
  for (const auto& [name, read, text] : text_formats()) {
    const auto file = read(write(name, "\xef\xbb\xbf" + text));
    expect_cube(file, name);
    EXPECT_EQ(file.remarks, "") << name;
    for (const char* mark : {"\xff\xfe", "\xfe\xff"}) {
      std::string wide = mark;
      for (const char c : text) wide.append({c, '\0'});
      EXPECT_EQ(error_of(read, write(name, wide)),
                "text in UTF-16: expected ASCII or UTF-8; save the file in one of these")
          << name;
    }
  }
}

TEST_F(a_text, may_end_its_lines_as_old_macs_or_dos_do) {
  for (const auto& [name, read, text] : text_formats())
    for (const char* end : {"\r", "\r\n", "\r\r\n"})
      expect_cube(read(write(name, replaced(text, "\n", end))), name);
  EXPECT_EQ(obj_error("v 0 0 0\rv 1 0 0\rv 0 1 0\r# here\rf 1 2 x\r"),
            "line 5: 'x': expected the number of a vertex");
  const auto file = obj_of("# one line of a Mac\rv 0 0 0\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3");
  EXPECT_EQ(file.mesh.facets.size(), 1u);
  for (const auto order : {std::endian::little, std::endian::big}) {
    mesh odd = cube();
    for (auto& v : odd.vertices) v[0] += 13.0 / 1024;  // a CR in its bytes
    std::string bytes = binary_ply(odd, order);
    const std::size_t data = bytes.find("end_header\n") + 11;
    bytes = replaced(bytes.substr(0, data), "\n", "\r") + bytes.substr(data);
    EXPECT_EQ(ph::read_ply(write("mac.ply", bytes)).mesh.corners(5), odd.corners(5));
  }
}

TEST_F(a_text, may_have_its_keywords_in_capitals) {
  for (const auto& [name, read, text] : text_formats())
    expect_cube(read(write(name, in_capitals(text))), name);
  std::string bytes = binary_ply(cube());
  for (const char* word : {"element", "vertex_indices", "double", "list"})
    bytes = replaced(bytes, word, in_capitals(word));
  expect_cube(ph::read_ply(write("a.ply", bytes)), "binary");
  EXPECT_EQ(ply_error("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float X\n"),
            "line 5: 'x': expected a property of another name");
}

TEST_F(a_text, that_is_no_mesh_is_called_what_it_is) {
  const std::string pointer =
      "version https://git-lfs.github.com/spec/v1\noid "
      "sha256:4d7a214614ab2935c943f9e0ff69d22eadbb8f32b1258daaa"
      "5e2ca24d17e2393\nsize 12345\n";
  const std::string gzip = "\x1f\x8b\x08" + std::string(181, 'a'), zip = std::string("PK\x03\x04\0\0", 6);
  const std::string page = "\xef\xbb\xbf\n<!DOCTYPE html>\n<html>";
  for (const auto& [name, read, text] : text_formats()) {
    EXPECT_EQ(error_of(read, write(name, pointer)),
              "a Git LFS pointer, not the file: expected what it points to; run `git lfs pull`");
    EXPECT_EQ(error_of(read, write(name, gzip)), "compressed by gzip: expected the file itself; unpack it");
    EXPECT_EQ(error_of(read, write(name, zip)), "a ZIP archive: expected the file itself; unpack it");
    EXPECT_EQ(error_of(read, write(name, page)),
              "an HTML page, not the file: expected the file itself; download that");
  }
  EXPECT_EQ(stl_error("\n" + obj(cube())),
            "line 2: 'v': expected 'solid'; it was cut off, or is not an STL file");
}

// What a standard library without std::from_chars of a double reads instead
TEST(a_number_in_a_text, is_that_of_from_chars) {
  for (const std::string text : {"0",        "-0",
                                 "1.5e3",    ".5",
                                 "-3.",      "1e999",
                                 "-1e999",   "1e-320",
                                 "inf",      "-inf",
                                 "nan",      "-nan",
                                 "0x10",     "-0x1p3",
                                 "1x",       " 1",
                                 "+1",       "-+1",
                                 "",         "-",
                                 ".",        "e5",
                                 "1e",       "1e+",
                                 "1,5",      "1.5.5",
                                 "infinity", "1i",
                                 "--1",      "\t1",
                                 "1e5 2",    "nanx",
                                 "- 1",      "1.7976931348623157e308"}) {
    const char *const begin = text.data(), *const end = begin + text.size();
    double expected = 5, found = 5;
    const auto a = std::from_chars(begin, end, expected);
    const auto b = ph::detail::from_chars_by_strtod(begin, end, found);
    EXPECT_TRUE(a.ec == b.ec && a.ptr == b.ptr) << text;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(found), std::bit_cast<std::uint64_t>(expected)) << text;
  }
}

}  // namespace
