// Meshes from OBJ files: what is read, what is passed over, what is wrong with a line.
#include "mesh_files.hpp"

#include <passive_haptics/scene/mesh/mesh.hpp>

namespace {

using namespace mesh_files;

struct an_obj_file : in_a_folder {};

TEST_F(an_obj_file, that_is_wrong_is_named_with_place_and_expectation) {
  const std::string v3 = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const auto& [text, error] : {
           std::pair{std::string(""), "no triangles: expected one or more; points and lines have no sides"},
           {"v 0 0 0\nv 1 0 0\nl 1 2\n",
            "no triangles: expected one or more; points and lines have no sides"},
           {v3 + "f 1 2 4\n", "line 4: '4': expected a vertex of the 3 above, from 1, or back from -1"},
           {v3 + "f 1 2 0\n", "line 4: '0': expected a vertex of the 3 above, from 1, or back from -1"},
           {v3 + "f 1 2 -4\n", "line 4: '-4': expected a vertex of the 3 above, from 1, or back from -1"},
           {v3 + "f 1 2 99999999999999999999\n",
            "line 4: '99999999999999999999': expected the number of a vertex"},
           {v3 + "f 1 2 /3\n", "line 4: '/3': expected the number of a vertex"},
           {v3 + "f 1 2\n", "line 4: the line ends: expected three corners or more"},
           {"v 0 0\nv 1 0 0\n", "line 1: the line ends: expected a coordinate"},
           {"v 0 0 0x10\n", "line 1: '0x10': expected a coordinate"},
           {"v 0 0 1e999\n", "line 1: '1e999': expected a coordinate"},
           {v3 + "v 0 0 nan\nf 1 2 4\n",
            "line 5: corner 3 = (0, 0, nan): expected finite coordinates; the file is damaged"},
           {v3 + "f 1 2 2\n", "all triangles are degenerate (zero area): expected one with an area"},
           {std::string("v 0 0 1\0\x1b[2J\n", 13),
            "line 1: a zero byte or Ctrl-Z: expected text; lines may be lost here: if none is, remove such "
            "bytes"},
           {"v 0,00 0,00 0,00\n",
            "line 1: '0,00': expected a coordinate; write a decimal point instead of the comma"},
           {"v 0 0 1.5e", "line 1: '1.5e': expected a coordinate; the file was cut off"},
           {v3 + "curv 0 1 1 2\n",
            "line 4: 'curv': expected v, f or another keyword of a mesh; curves and free-form surfaces are "
            "not supported"},
           {std::string(100, 'x'),
            "line 1: 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...': expected a keyword of a mesh; the file "
            "has "
            "no triangles"},
       }) {
    EXPECT_EQ(obj_error(text), error) << text;
  }
}

TEST_F(an_obj_file, may_join_lines_by_a_backslash_without_a_blank) {
  const std::string v4 = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  for (const char* end : {"\n", "\r\n", "\r"}) {
    const auto file =
        obj_of(replaced(v4 + "f 1 3\\\n2\nf 1\\\n2\\\n4\\\n\nf 1/1\\\n\\\n4/4 3\n f\\\n2 3 4", "\n", end));
    ASSERT_EQ(file.mesh.facets.size(), 4u);
    EXPECT_TRUE(ph::triangle_mesh(file.mesh).closed());
    EXPECT_GT(ph::triangle_mesh(file.mesh).content(), 0);
  }
  EXPECT_EQ(obj_error(v4 + "f 1\\\n2\\\nx\n"), "line 7: 'x': expected the number of a vertex");
  // Of lines that are passed over, too; but a comment or a name that ends in a backslash hides nothing
  EXPECT_EQ(obj_of(v4 + "vt 0 \\\n0\nl 1 2\\\n3\ng a\\\nb\nf 1 2 3\n").not_triangles, 1);
  EXPECT_EQ(obj_of(v4 + "f 1 2 3 # C:\\models\\\n# C:\\models\\\nf 1 2 4\n").mesh.facets.size(), 2u);
  EXPECT_EQ(obj_error(v4 + "usemtl C:\\paint\\\nf 1 2 3\n"),
            "line 6: 'f': expected no vertex or face behind a line that ends in a backslash; remove the "
            "backslash");
}

TEST_F(an_obj_file, may_have_keywords_that_are_not_read) {
  const auto file = obj_of("v 0 0 0\nvc 1 0 0\nv 1 0 0\nv 0 1 0\nKd 1 0 0\nfo 1 2 3\nbone_2 1\n");
  EXPECT_EQ(file.mesh.facets.size(), 1u);
  EXPECT_EQ(file.skipped_lines, 3);
  EXPECT_EQ(file.remarks, "lines with keywords of other programs, skipped: 3, the first is line 2: 'vc'\n");
  for (const char* word : {"w", "0.5", "f:", "<html>", "surf", "CURV", "call", "curv2"})
    EXPECT_EQ(
        obj_error("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n" + std::string(word) + " 1 2 3\n"),
        "line 5: '" + std::string(word) +
            "': expected v, f or another keyword of a mesh; curves and free-form surfaces are not supported");
}

TEST_F(an_obj_file, says_all_that_was_left_out) {
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

}  // namespace
