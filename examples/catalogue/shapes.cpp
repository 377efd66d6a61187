#include <catalogue/entries.hpp>

#include <passive_haptics/scene/files/file_bytes.hpp>
#include <passive_haptics/scene/files/obj.hpp>
#include <passive_haptics/scene/files/ply.hpp>
#include <passive_haptics/scene/files/stl.hpp>
#include <passive_haptics/scene/files/text_lines.hpp>
#include <passive_haptics/scene/mesh/height_field.hpp>
#include <passive_haptics/scene/mesh/mesh_solid.hpp>
#include <passive_haptics/scene/mesh/mesh_surface.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/box.hpp>
#include <passive_haptics/scene/shapes/capsule.hpp>
#include <passive_haptics/scene/shapes/complement.hpp>
#include <passive_haptics/scene/shapes/convex_polygon.hpp>
#include <passive_haptics/scene/shapes/convex_polytope.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/scene/shapes/offset.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <type_traits>
#include <vector>

namespace example {
namespace {

namespace ph = passive_haptics;
using ph::runtime::any_parameters;
using ph::runtime::any_shape;

// A shape with parameters P, made by make(p, of); of: the shape that it is made from, or nullptr.
template <int D, class P, class Make>
ph::runtime::shape_entry<D> entry_of(const char* name, bool takes_shape, Make make) {
  const auto shape = [make](const any_parameters& p, const any_shape<D>* of) {
    return any_shape<D>(make(p.as<P>(), of));
  };
  return {name, any_parameters(P()), takes_shape, shape,
          [make](const any_parameters& p, const any_shape<D>* of, double stiffness) {
            return ph::any_wall<D>(ph::wall(make(p.as<P>(), of), stiffness));
          }};
}

// Calls make(K) with the number of list items as a constant, Least <= K <= Most.
template <std::size_t Least, std::size_t Most, class Make>
auto of_count(std::size_t count, const char* items, Make make) {
  if constexpr (Least < Most)
    if (count > Least && count <= Most) return of_count<Least + 1, Most>(count, items, make);
  if (count != Least)
    throw std::invalid_argument("passive_haptics: number of " + std::string(items) + " = " +
                                std::to_string(count) + ": expected " + std::to_string(Least) + " to " +
                                std::to_string(Most));
  return make(std::integral_constant<std::size_t, Least>());
}

// Any number of corners of a polygon.
struct corner_list {
  std::vector<ph::point<2>> corners;

  static constexpr auto members() {
    return ph::member_table(ph::member("corners", &corner_list::corners, "m", ph::range::finite));
  }
};

any_shape<2> polygon_of(const std::vector<ph::point<2>>& corners) {
  return of_count<3, 8>(corners.size(), "corners of a convex_polygon", [&](auto count) {
    ph::convex_polygon_parameters<int(count)> p;
    std::copy_n(corners.begin(), count, p.corners.begin());
    return any_shape<2>(ph::convex_polygon<int(count)>(p));
  });
}

// Any number of faces of a polytope.
template <int D>
struct face_list {
  std::vector<ph::half_space_parameters<D>> faces;

  static constexpr auto members() { return ph::member_table(ph::member("faces", &face_list::faces)); }
};

template <int D>
any_shape<D> polytope_of(const std::vector<ph::half_space_parameters<D>>& faces) {
  return of_count < D == 2 ? 2 : 4,
         D == 2 ? 4 : 8 > (faces.size(), "faces of a convex_polytope", [&](auto count) {
                        ph::convex_polytope_parameters<D, int(count)> p;
                        std::copy_n(faces.begin(), count, p.faces.begin());
                        return any_shape<D>(ph::convex_polytope<D, int(count)>(p));
                      });
}

// A mesh in a file.
struct mesh_file_parameters {
  std::string file;                            // .stl, .ply or .obj
  double metres_per_unit = 1e-3;               // of the file's numbers
  ph::vector<double, 3> position = {0, 0, 0};  // of its origin [m]

  static constexpr auto members() {
    using p = mesh_file_parameters;
    return ph::member_table(ph::member("file", &p::file),
                            ph::member("metres_per_unit", &p::metres_per_unit, "m", ph::range::positive),
                            ph::member("position", &p::position, "m", ph::range::finite));
  }
};

ph::mesh<3> mesh_of(const mesh_file_parameters& p) {
  std::string ending = std::filesystem::path(p.file).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  const auto read = ending == ".stl"   ? &ph::read_stl
                    : ending == ".ply" ? &ph::read_ply
                    : ending == ".obj" ? &ph::read_obj
                                       : nullptr;
  if (read == nullptr)
    throw std::invalid_argument("passive_haptics: file = \"" + p.file +
                                "\": expected a mesh, a .stl, .ply or .obj");
  ph::mesh_file found = read(p.file, p.metres_per_unit);
  for (auto& v : found.mesh.vertices) v += p.position;
  return ph::mesh<3>(std::move(found.mesh));
}

// Heights in a file: one line per row, separated by blanks or commas.
struct height_file_parameters {
  std::string file;
  double metres_per_unit = 1e-3;  // of the file's numbers
  double spacing_x = 0;           // between two numbers of a line [m]
  double spacing_y = 0;           // between two lines [m]
  ph::point<3> origin{0, 0, 0};   // of the first number, at height 0 [m]

  static constexpr auto members() {
    using p = height_file_parameters;
    return ph::member_table(ph::member("file", &p::file),
                            ph::member("metres_per_unit", &p::metres_per_unit, "m", ph::range::positive),
                            ph::member("spacing_x", &p::spacing_x, "m", ph::range::positive),
                            ph::member("spacing_y", &p::spacing_y, "m", ph::range::positive),
                            ph::member("origin", &p::origin, "m", ph::range::finite));
  }
};

ph::mesh<3> terrain_of(const height_file_parameters& p) {
  std::string text;
  if (const std::string error = ph::read_file(p.file, text); !error.empty())
    throw std::invalid_argument("file " + p.file + ": " + error);
  std::ranges::replace(text, ',', ' ');
  ph::height_field_parameters field{
      .spacing_x = p.spacing_x, .spacing_y = p.spacing_y, .heights = {}, .origin = p.origin};
  std::istringstream lines(text);
  int number = 1;
  for (std::string line; std::getline(lines, line); ++number) {
    std::istringstream words(line);
    bool is_valid = true;
    int count = 0;
    for (std::string word; words >> word; ++count) {
      double z = 0;
      const auto read = ph::detail::read_number(word, z);
      is_valid = is_valid && read.ec == std::errc() && read.ptr == word.data() + word.size();
      field.heights.push_back(z * p.metres_per_unit);
    }
    if (field.rows == 0) field.columns = count;
    if (!is_valid || (count > 0 && count != field.columns))
      throw std::invalid_argument("file " + p.file + ", line " + std::to_string(number) + ": \"" + line +
                                  "\": expected numbers between blanks or commas, as many as in the first "
                                  "line");
    field.rows += count > 0;
  }
  return ph::mesh<3>(ph::height_field(field));
}

// A surface with parameters P, without an inside; mesh_of(p) reads its mesh.
template <class P, class Mesh>
ph::runtime::shape_entry<3> surface_of(const char* name, Mesh mesh_of) {
  return {name, any_parameters(P()), false, nullptr,
          [mesh_of](const any_parameters& p, const any_shape<3>*, double stiffness) {
            return ph::any_wall<3>(ph::wall(ph::mesh_surface<3>(mesh_of(p.as<P>())), stiffness));
          }};
}

}  // namespace

void add_shapes(ph::runtime::catalogue& all) {
  const auto add = [&]<int D>() {
    all.add_shape<ph::half_space<D>, ph::half_space_parameters<D>>("half_space");
    all.add_shape<ph::ball<D>, ph::ball_parameters<D>>("ball");
    all.add_shape<ph::box<D>, ph::box_parameters<D>>("box");
    all.add_shape<ph::capsule<D>, ph::capsule_parameters<D>>("capsule");
    all.add_shape(entry_of<D, ph::offset_parameters>(
        "offset", true, [](const auto& p, const any_shape<D>* of) { return ph::offset(*of, p.growth); }));
    all.add_shape(entry_of<D, ph::runtime::no_parameters>(
        "complement", true, [](const auto&, const any_shape<D>* of) { return ph::complement(*of); }));
    all.add_shape(entry_of<D, face_list<D>>("convex_polytope", false, [](const auto& p, const any_shape<D>*) {
      return polytope_of<D>(p.faces);
    }));
  };
  add.operator()<2>();
  add.operator()<3>();
  all.add_shape(entry_of<2, corner_list>(
      "convex_polygon", false, [](const auto& p, const any_shape<2>*) { return polygon_of(p.corners); }));
  all.add_shape(entry_of<3, mesh_file_parameters>(
      "mesh_solid", false, [](const auto& p, const any_shape<3>*) { return ph::mesh_solid<3>(mesh_of(p)); }));
  all.add_shape(surface_of<mesh_file_parameters>("mesh_surface", mesh_of));
  all.add_shape(surface_of<height_file_parameters>("height_field", terrain_of));
}

}  // namespace example
