// Files as other programs write them: what is unambiguous is read, what was passed over is counted, and the
// rest is refused with its line.
#include "mesh_files.hpp"

#include <passive_haptics/scene/mesh/mesh.hpp>

#include <bit>
#include <charconv>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace {

using namespace mesh_files;

using file_reader = std::function<ph::mesh_file(const fs::path&)>;
const file_reader read_stl = [](const fs::path& p) { return ph::read_stl(p); },
                  read_obj = [](const fs::path& p) { return ph::read_obj(p); },
                  read_ply = [](const fs::path& p) { return ph::read_ply(p); };

struct text_format {
  const char* name;
  file_reader read;
  std::string cube;
};
std::vector<text_format> text_formats() {
  return {{"text.stl", read_stl, ascii_stl(cube())},
          {"text.obj", read_obj, obj(cube())},
          {"text.ply", read_ply, ascii_ply(cube())}};
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}
std::string in_capitals(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 32);
  return text;
}

struct a_file_of_another_program : in_a_folder {
  // The cube as it was written, nothing turned or lost.
  void expect_cube(const ph::mesh_file& file, const std::string& about) const {
    const mesh all = cube();
    ASSERT_EQ(file.mesh.facets.size(), all.facets.size()) << about;
    for (std::size_t f = 0; f < all.facets.size(); ++f)
      EXPECT_EQ(file.mesh.corners(f), all.corners(f)) << about << ", facet " << f;
    EXPECT_EQ(file.slivers + file.not_triangles + file.twisted_quads, 0) << about;
  }
  ph::mesh_file obj_of(const std::string& text) const { return ph::read_obj(write("a.obj", text)); }
  std::string obj_error(const std::string& text) const { return error_of(read_obj, write("a.obj", text)); }
  std::string stl_error(const std::string& text) const { return error_of(read_stl, write("a.stl", text)); }
  std::string ply_error(const std::string& text) const { return error_of(read_ply, write("a.ply", text)); }
};

// ---- texts

TEST_F(a_file_of_another_program, may_end_in_a_zero_byte_or_ctrl_z) {
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
TEST_F(a_file_of_another_program, may_end_in_many_zero_bytes_if_it_is_whole_all_the_same) {
  const std::string zeros(512, '\0');
  for (const auto& [name, read, text] : text_formats()) {
    if (std::string(name) == "text.obj") continue;
    const auto file = read(write(name, text + zeros));
    expect_cube(file, name);
    EXPECT_EQ(file.skipped_bytes, 512u) << name;
    EXPECT_NE(error_of(read, write(name, text.substr(0, text.size() - 30) + zeros)), "none") << name;
  }
  EXPECT_EQ(
      obj_error(obj(cube()) + zeros),
      "line 21: a zero byte or Ctrl-Z, expected text; lines may be lost here: if none is, remove such bytes");
}

TEST_F(a_file_of_another_program, may_begin_with_the_mark_of_utf_8) {
  for (const auto& [name, read, text] : text_formats()) {
    const auto file = read(write(name, "\xef\xbb\xbf" + text));
    expect_cube(file, name);
    EXPECT_EQ(file.remarks, "") << name;
    for (const char* mark : {"\xff\xfe", "\xfe\xff"}) {
      std::string wide = mark;
      for (const char c : text) wide.append({c, '\0'});
      EXPECT_EQ(error_of(read, write(name, wide)),
                "text in UTF-16, expected ASCII or UTF-8; save the file in one of these")
          << name;
    }
  }
}

TEST_F(a_file_of_another_program, may_end_its_lines_as_old_macs_or_dos_do) {
  for (const auto& [name, read, text] : text_formats())
    for (const char* end : {"\r", "\r\n", "\r\r\n"})
      expect_cube(read(write(name, replaced(text, "\n", end))), name);
  EXPECT_EQ(obj_error("v 0 0 0\rv 1 0 0\rv 0 1 0\r# here\rf 1 2 x\r"),
            "line 5: 'x', expected the number of a vertex");
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

TEST_F(a_file_of_another_program, may_have_its_keywords_in_capitals) {
  for (const auto& [name, read, text] : text_formats())
    expect_cube(read(write(name, in_capitals(text))), name);
  std::string bytes = binary_ply(cube());
  for (const char* word : {"element", "vertex_indices", "double", "list"})
    bytes = replaced(bytes, word, in_capitals(word));
  expect_cube(ph::read_ply(write("a.ply", bytes)), "binary");
  EXPECT_EQ(ply_error("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float X\n"),
            "line 5: 'x', expected a property of another name");
}

// ---- STL

TEST_F(a_file_of_another_program, of_stl_may_have_blanks_before_and_in_its_keywords) {
  const std::string text = ascii_stl(cube());
  expect_cube(ph::read_stl(write("a.stl", " \n\t" + text)), "blanks");
  for (const char* word : {"endsolid", "endfacet", "endloop"})
    expect_cube(ph::read_stl(write("a.stl", replaced(text, word, std::string("end ") + (word + 3)))), word);
  expect_cube(ph::read_stl(write("a.stl", replaced(text, "normal nan 0 0", "normal"))), "no normals");
  EXPECT_EQ(stl_error("solid a\nend facet\n"), "line 2: 'end', expected 'facet' or 'endsolid'");
  EXPECT_EQ(stl_error(replaced(text, "endloop", "end facet")), "line 7: 'facet', expected 'loop'");
}

TEST_F(a_file_of_another_program, of_stl_may_have_comments_and_colours_between_facets) {
  const std::string text = replaced(ascii_stl(cube()), "facet normal", "color 1 0 0\nfacet normal");
  const auto file = ph::read_stl(write("a.stl", "# made by hand\n" + text + "; the end\n"));
  expect_cube(file, "colours");
  EXPECT_EQ(file.skipped_lines, 14);
  EXPECT_EQ(file.remarks, "lines with keywords of other programs, skipped: 14, the first is line 1: '#'\n");
  EXPECT_EQ(stl_error(replaced(text, "color", "colour")), "line 2: 'colour', expected 'facet' or 'endsolid'");
}

TEST_F(a_file_of_another_program, of_stl_may_have_bytes_behind_its_triangles) {
  for (const char* title : {"", "solid but binary"}) {
    const std::string bytes = binary_stl(cube(), title);
    for (const std::string& more : {std::string("\n"), std::string("made by a scanner"), std::string(49, 'x'),
                                    std::string(70, 'x'), std::string(5000, '\0')}) {
      const auto file = ph::read_stl(write("a.stl", bytes + more));
      expect_cube(file, more);
      EXPECT_EQ(file.skipped_bytes, more.size());
      EXPECT_EQ(file.remarks,
                "bytes behind the end of the data, skipped: " + std::to_string(more.size()) + "\n");
    }
    EXPECT_EQ(stl_error(bytes.substr(0, bytes.size() - 1)),
              "byte 683: the file ends, expected 684 bytes, those of 12 triangles; it was cut off, or is no "
              "STL");
  }
}

// A count that was never filled in, or a second solid.
TEST_F(a_file_of_another_program, of_stl_with_more_triangles_than_it_says_is_refused) {
  const std::string bytes = binary_stl(cube());
  EXPECT_EQ(
      stl_error(bytes + bytes.substr(84)),
      "byte 80: a count of 12 triangles, expected 24, for which the file has bytes; write the file anew");
  for (const int count : {0, 1, 5}) {
    std::string wrong = bytes;
    wrong[80] = static_cast<char>(count);
    for (const std::string& more : {std::string(), std::string("ab")})
      EXPECT_EQ(stl_error(wrong + more),
                "byte 80: a count of " + std::to_string(count) +
                    " triangles, expected 12, for which the file has bytes; write the "
                    "file anew");
  }
}

TEST_F(a_file_of_another_program, that_is_no_mesh_is_called_what_it_is) {
  const std::string pointer =
      "version https://git-lfs.github.com/spec/v1\noid "
      "sha256:4d7a214614ab2935c943f9e0ff69d22eadbb8f32b1258daaa"
      "5e2ca24d17e2393\nsize 12345\n";
  const std::string gzip = "\x1f\x8b\x08" + std::string(181, 'a'), zip = std::string("PK\x03\x04\0\0", 6);
  const std::string page = "\xef\xbb\xbf\n<!DOCTYPE html>\n<html>";
  for (const auto& [name, read, text] : text_formats()) {
    EXPECT_EQ(error_of(read, write(name, pointer)),
              "a Git LFS pointer, not the file, expected what it points to; run `git lfs pull`");
    EXPECT_EQ(error_of(read, write(name, gzip)), "compressed by gzip, expected the file itself; unpack it");
    EXPECT_EQ(error_of(read, write(name, zip)), "a ZIP archive, expected the file itself; unpack it");
    EXPECT_EQ(error_of(read, write(name, page)),
              "an HTML page, not the file, expected the file itself; download that");
  }
  EXPECT_EQ(stl_error("\n" + obj(cube())), "line 2: 'v', expected 'solid'; it was cut off, or is no STL");
}

// ---- OBJ

TEST_F(a_file_of_another_program, of_obj_may_join_lines_by_a_backslash_without_a_blank) {
  const std::string v4 = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  for (const char* end : {"\n", "\r\n", "\r"}) {
    const auto file =
        obj_of(replaced(v4 + "f 1 3\\\n2\nf 1\\\n2\\\n4\\\n\nf 1/1\\\n\\\n4/4 3\n f\\\n2 3 4", "\n", end));
    ASSERT_EQ(file.mesh.facets.size(), 4u);
    EXPECT_TRUE(ph::triangle_mesh(file.mesh).closed());
    EXPECT_GT(ph::triangle_mesh(file.mesh).content(), 0);
  }
  EXPECT_EQ(obj_error(v4 + "f 1\\\n2\\\nx\n"), "line 7: 'x', expected the number of a vertex");
  // Of lines that are passed over, too; but a comment or a name that ends in a backslash hides nothing
  EXPECT_EQ(obj_of(v4 + "vt 0 \\\n0\nl 1 2\\\n3\ng a\\\nb\nf 1 2 3\n").not_triangles, 1);
  EXPECT_EQ(obj_of(v4 + "f 1 2 3 # C:\\models\\\n# C:\\models\\\nf 1 2 4\n").mesh.facets.size(), 2u);
  EXPECT_EQ(obj_error(v4 + "usemtl C:\\paint\\\nf 1 2 3\n"),
            "line 6: 'f', expected no vertex or face behind a line that ends in a backslash; remove the "
            "backslash");
}

TEST_F(a_file_of_another_program, of_obj_may_have_keywords_that_are_not_read) {
  const auto file = obj_of("v 0 0 0\nvc 1 0 0\nv 1 0 0\nv 0 1 0\nKd 1 0 0\nfo 1 2 3\nbone_2 1\n");
  EXPECT_EQ(file.mesh.facets.size(), 1u);
  EXPECT_EQ(file.skipped_lines, 3);
  EXPECT_EQ(file.remarks, "lines with keywords of other programs, skipped: 3, the first is line 2: 'vc'\n");
  for (const char* word : {"w", "0.5", "f:", "<html>", "surf", "CURV", "call", "curv2"})
    EXPECT_EQ(
        obj_error("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n" + std::string(word) + " 1 2 3\n"),
        "line 5: '" + std::string(word) +
            "', expected v, f or another keyword of a mesh; curves and free-form surfaces are not read");
}

TEST_F(a_file_of_another_program, says_all_that_was_left_out) {
  const auto file = obj_of(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 2\nl 1 2\np 1\nKd 1\nv 0.3 0 0.08\nv 0.294 -0.002 0.086\n"
      "v 0.3065 0.006 0.004\nv 0.3 -0.010 -0.002\nf 4 5 6 7\n");
  EXPECT_EQ(
      file.remarks,
      "triangles without area, left out: 1; the mesh may be open there\n"
      "points and lines, left out: 2\n"
      "twisted quads, cut along a diagonal: 1, the first at line 13; how they run between their edges is "
      "a guess\n"
      "lines with keywords of other programs, skipped: 1, the first is line 8: 'Kd'\n");
}

// ---- PLY

TEST_F(a_file_of_another_program, of_ply_may_have_comments_and_empty_lines_anywhere_in_its_header) {
  const std::string text = ascii_ply(cube());
  expect_cube(
      ph::read_ply(write("a.ply", replaced(text, "format", "comment by a scanner\n\nobj_info 1\nformat"))),
      "before the format");
  expect_cube(ph::read_ply(write("a.ply", replaced(text, "a cube", "C:\\scans\\"))), "backslash");
  EXPECT_EQ(ply_error("ply\ncomment a\n\nelement vertex 3\n"), "line 4: 'element', expected 'format'");

  // A line of a program that forgets the keyword; behind an element it might be one of the properties
  const auto file = ph::read_ply(write("a.ply", replaced(text, "comment a cube", "Created by a program")));
  expect_cube(file, "no keyword");
  EXPECT_EQ(file.remarks,
            "lines with keywords of other programs, skipped: 1, the first is line 3: 'Created'\n");
  EXPECT_EQ(ply_error(replaced(text, "property uchar", "proprty uchar")),
            "line 8: 'proprty', expected element, property, comment, obj_info or end_header");
}

TEST_F(a_file_of_another_program, of_ply_may_have_any_values_that_are_not_read) {
  const std::string text = ascii_ply(cube());
  const std::size_t faces = text.find("\n3 ");
  expect_cube(ph::read_ply(write("a.ply", replaced(text.substr(0, faces) + "\n", " 7\n", " -1.#IND\n") +
                                              text.substr(faces + 1))),
              "no number");
  expect_cube(ph::read_ply(write("a.ply", replaced(ascii_ply(cube()), "end_header",
                                                   "element material 0\nelement tristrips 0\nend_header"))),
              "no rows");
  EXPECT_EQ(ply_error(replaced(ascii_ply(cube()), "end_header",
                               "element tristrips 1\nproperty list int int vertex_indices\nend_header") +
                      "3 0 1 2\n"),
            "the header is not that of a mesh, expected faces alone; triangle strips are not read");
}

TEST_F(a_file_of_another_program, of_ply_may_have_an_end_of_line_behind_its_data) {
  for (const std::string& end : {std::string("\n"), std::string("\r\n"), std::string("\0\x1a", 2)}) {
    const auto file = ph::read_ply(write("a.ply", binary_ply(cube()) + end));
    expect_cube(file, "binary");
    EXPECT_EQ(file.skipped_bytes, end.size());
  }
}

// ---- vertices

// A scanner writes NaN where it saw nothing.
TEST_F(a_file_of_another_program, may_have_vertices_that_are_no_numbers_if_no_face_uses_them) {
  mesh with_hole = cube();
  with_hole.vertices.insert(with_hole.vertices.begin() + 3, ph::point<3>(0, std::nan(""), 1));
  with_hole.vertices.emplace_back(std::nan(""), 0, 0);
  for (auto& f : with_hole.facets)
    for (int& v : f) v += v >= 3;
  expect_cube(ph::read_obj(write("a.obj", obj(with_hole))), "obj");
  for (const char* nan : {"-1.#IND", "1.#QNAN00", "1.#INF"})
    expect_cube(ph::read_obj(write("a.obj", replaced(obj(with_hole), "nan", nan))), nan);
  expect_cube(ph::read_ply(write("a.ply", ascii_ply(with_hole))), "text");
  expect_cube(ph::read_ply(write("b.ply", binary_ply(with_hole))), "binary");

  with_hole.facets[2][1] = 3;
  const std::string wrong = "corner 2 = (0, nan, 1), expected finite coordinates; the file is damaged";
  EXPECT_EQ(obj_error(obj(with_hole)), "line 13: " + wrong);
  EXPECT_EQ(obj_error(replaced(obj(with_hole), "nan", "-1.#IND")), "line 13: " + wrong);
  EXPECT_NE(obj_error(replaced(obj(with_hole), "nan", "2.#IND")), "line 13: " + wrong);
  EXPECT_EQ(ply_error(ascii_ply(with_hole)), "line 24: " + wrong);
  EXPECT_EQ(stl_error(ascii_stl(with_hole)), "line 16: " + wrong);
  EXPECT_EQ(stl_error(binary_stl(with_hole)), "byte 184: " + wrong);
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
