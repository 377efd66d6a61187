// Meshes from STL files, as text and binary.
#include "mesh_files.hpp"

namespace {

using namespace mesh_files;

struct an_stl_file : in_a_folder {};

TEST_F(an_stl_file, that_is_wrong_is_named_with_place_and_expectation) {
  const std::string whole = binary_stl(cube()), ascii = ascii_stl(cube());
  for (const auto& [text, error] : {
           std::pair{std::string(""),
                     "line 1: the file ends: expected 'solid'; it was cut off, or is not an STL file"},
           {whole.substr(0, 83),
            "line 1: the file ends: expected 'solid'; it was cut off, or is not an STL file"},
           {whole.substr(0, 84),
            "byte 84: the file ends: expected 684 bytes, those of 12 triangles; it was cut off, or is not an "
            "STL file"},
           {std::string(80, ' ') + "\xff\xff\xff\xff",
            "line 1: '\xff\xff\xff\xff': expected 'solid'; it was cut off, or is not an STL file"},
           {ascii.substr(0, ascii.find("endloop")), "line 7: the file ends: expected 'endloop'"},
           {"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 zero", "line 4: 'zero': expected a number"},
           {"solid a\nendsolid a\nfacet", "line 3: 'facet': expected 'solid', or the end of the file"},
           {"solid a\n", "line 2: the file ends: expected 'facet' or 'endsolid'"},
           {"solid a\nendsolid", "no triangles: expected one or more; points and lines have no sides"},
       })
    EXPECT_EQ(stl_error(text).substr(0, 200), error) << text.substr(0, 100);
}

TEST_F(an_stl_file, may_have_blanks_before_and_in_its_keywords) {
  const std::string text = ascii_stl(cube());
  expect_cube(ph::read_stl(write("a.stl", " \n\t" + text)), "blanks");
  for (const char* word : {"endsolid", "endfacet", "endloop"})
    expect_cube(ph::read_stl(write("a.stl", replaced(text, word, std::string("end ") + (word + 3)))), word);
  expect_cube(ph::read_stl(write("a.stl", replaced(text, "normal nan 0 0", "normal"))), "no normals");
  EXPECT_EQ(stl_error("solid a\nend facet\n"), "line 2: 'end': expected 'facet' or 'endsolid'");
  EXPECT_EQ(stl_error(replaced(text, "endloop", "end facet")), "line 7: 'facet': expected 'loop'");
}

TEST_F(an_stl_file, may_have_comments_and_colours_between_facets) {
  const std::string text = replaced(ascii_stl(cube()), "facet normal", "color 1 0 0\nfacet normal");
  const auto file = ph::read_stl(write("a.stl", "# made by hand\n" + text + "; the end\n"));
  expect_cube(file, "colours");
  EXPECT_EQ(file.skipped_lines, 14);
  EXPECT_EQ(file.remarks, "lines with keywords of other programs, skipped: 14, the first is line 1: '#'\n");
  EXPECT_EQ(stl_error(replaced(text, "color", "colour")), "line 2: 'colour': expected 'facet' or 'endsolid'");
}

TEST_F(an_stl_file, may_have_bytes_behind_its_triangles) {
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
              "byte 683: the file ends: expected 684 bytes, those of 12 triangles; it was cut off, or is not "
              "an STL file");
  }
}

// A count that was never filled in, or a second solid.
TEST_F(an_stl_file, with_more_triangles_than_it_says_is_refused) {
  const std::string bytes = binary_stl(cube());
  EXPECT_EQ(
      stl_error(bytes + bytes.substr(84)),
      "byte 80: a count of 12 triangles: expected 24, for which the file has bytes; write the file again");
  for (const int count : {0, 1, 5}) {
    std::string wrong = bytes;
    wrong[80] = static_cast<char>(count);
    for (const std::string& more : {std::string(), std::string("ab")})
      EXPECT_EQ(stl_error(wrong + more),
                "byte 80: a count of " + std::to_string(count) +
                    " triangles: expected 12, for which the file has bytes; write the file again");
  }
}

}  // namespace
