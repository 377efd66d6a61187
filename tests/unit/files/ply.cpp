// Meshes from PLY files: headers and data.
#include "mesh_files.hpp"

namespace {

using namespace mesh_files;

struct a_ply_file : in_a_folder {};

TEST_F(a_ply_file, that_is_wrong_is_named_with_place_and_expectation) {
  const auto head = [](const std::string& counts, const std::string& format = "ascii") {
    return "ply\nformat " + format +
           " 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
           "property float z\nelement face " +
           counts + "\nproperty list uchar int vertex_indices\nend_header\n";
  };
  const std::string v3 = "0 0 0\n1 0 0\n0 1 0\n";
  const std::string no_mesh = "the header is not that of a mesh: expected ";
  for (const auto& [text, error] : {
           std::pair{
               head("1") + v3 + "3 0 1 99999\n",
               std::string(
                   "line 13: 'vertex 99999': expected 0 or more and less than 3, as many as there are")},
           {head("1") + v3 + "3 0 1 -5\n",
            "line 13: 'vertex -5': expected 0 or more and less than 3, as many as there are"},
           {head("1") + v3 + "3 0 1 2.5\n", "line 13: '2.5': expected a whole number"},
           {head("1") + v3 + "3 0 1\n", "line 14: the file ends: expected a whole number"},
           {head("1") + v3 + "-1 0 1 2\n",
            "line 13: 'a list of -1 values': expected 0 or more, and no more than the file has"},
           {head("1") + v3 + "200 0 1 2\n",
            "line 13: 'a list of 200 values': expected 0 or more, and no more than the file has"},
           {head("1") + v3 + "3 0 1 2\n3 0 1 2\n",
            "line 14: '3': expected the end of the file, as the header says"},
           {head("99999999999") + v3 + "3 0 1 2\n",
            "element face has 99999999999 rows of 2 bytes or more: expected no more than the 26 bytes that "
            "follow the "
            "header"},
           {head("99999999999999999999") + v3,
            "line 7: '99999999999999999999': expected how many rows there are"},
           {head("-1") + v3, "line 7: '-1': expected how many rows there are"},
           {head("1", "binary") + v3,
            "line 2: 'binary': expected ascii, binary_little_endian or binary_big_endian"},
           {"", "line 1: the file ends: expected 'ply'"},
           {"plyx", "line 1: 'plyx': expected 'ply'"},
           {"ply", "line 1: the file ends: expected 'end_header' and the data; the file was cut off"},
           {std::string("ply\n\0", 5),
            "line 2: the file ends: expected 'end_header' and the data; the file was cut off"},
           {"ply\nformat ascii 2.0\n", "line 2: '2.0': expected version 1.0"},
           {"ply\nformat ascii 1.0\nproperty float x\n",
            "line 3: 'property': expected element, property, comment, obj_info or end_header"},
           {"ply\nformat ascii 1.0\nelement vertex 3\nproperty real x\n",
            "line 4: 'real': expected a type: char, uchar, short, ushort, int, uint, float or double"},
           {"ply\nformat ascii 1.0\nelement vertex 3\nproperty list float int x\n",
            "line 4: 'float': expected a type of whole numbers"},
           {"ply\nformat ascii 1.0\nelement vertex 3\nelement vertex 3\n",
            "line 4: 'vertex': expected an element of another name"},
           {"ply\nformat ascii 1.0\nelement vertex 3\nproperty int x\nproperty int x\n",
            "line 5: 'x': expected a property of another name"},
           {"ply\nformat ascii 1.0\nend_header\n", no_mesh + "'element vertex' and how many there are"},
           {"ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nend_header\n0 0\n",
            no_mesh + "properties x, y and z of the vertices"},
           {"ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nproperty int "
            "z\nend_header\n0 0 0\n",
            no_mesh + "'element face' and how many there are"},
           {"ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nproperty int "
            "z\nelement face 1\n"
            "property list uchar float vertex_indices\nend_header\n0 0 0\n3 0 0 0\n",
            no_mesh + "'property list uchar int vertex_indices' of the faces"},
       }) {
    EXPECT_EQ(ply_error(text), error) << text;
  }

  const std::string whole = binary_ply(cube());
  auto bad = cube();
  bad.facets[3][1] = 8;
  constexpr std::size_t row = 1 + 3 * 4;  // of a face
  EXPECT_EQ(error_of(ply, write("b.ply", binary_ply(bad))),
            "byte " + std::to_string(whole.size() - 9 * row + 1 + 2 * 4) +
                ": before it vertex 8: expected 0 or more and less than 8, as many as there are");
  EXPECT_NE(error_of(ply, write("c.ply", whole.substr(0, whole.size() - 5))).find("a list of 3 values"),
            std::string::npos);
  EXPECT_EQ(error_of(ply, write("d.ply", whole + "xy")),
            "byte " + std::to_string(whole.size()) +
                ": 2 bytes more: expected the end of the file, as the "
                "header says");
}

TEST_F(a_ply_file, may_have_comments_and_empty_lines_anywhere_in_its_header) {
  const std::string text = ascii_ply(cube());
  expect_cube(
      ph::read_ply(write("a.ply", replaced(text, "format", "comment by a scanner\n\nobj_info 1\nformat"))),
      "before the format");
  expect_cube(ph::read_ply(write("a.ply", replaced(text, "a cube", "C:\\scans\\"))), "backslash");
  EXPECT_EQ(ply_error("ply\ncomment a\n\nelement vertex 3\n"), "line 4: 'element': expected 'format'");

  // A line of a program that forgets the keyword; behind an element it might be one of the properties
  const auto file = ph::read_ply(write("a.ply", replaced(text, "comment a cube", "Created by a program")));
  expect_cube(file, "no keyword");
  EXPECT_EQ(file.remarks,
            "lines with keywords of other programs, skipped: 1, the first is line 3: 'Created'\n");
  EXPECT_EQ(ply_error(replaced(text, "property uchar", "proprty uchar")),
            "line 8: 'proprty': expected element, property, comment, obj_info or end_header");
}

TEST_F(a_ply_file, may_have_any_values_that_are_not_read) {
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
            "the header is not that of a mesh: expected faces; triangle strips are not supported");
}

TEST_F(a_ply_file, may_have_an_end_of_line_behind_its_data) {
  for (const std::string& end : {std::string("\n"), std::string("\r\n"), std::string("\0\x1a", 2)}) {
    const auto file = ph::read_ply(write("a.ply", binary_ply(cube()) + end));
    expect_cube(file, "binary");
    EXPECT_EQ(file.skipped_bytes, end.size());
  }
}

}  // namespace
