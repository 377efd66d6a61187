#include <catalogue/entries.hpp>

#include <passive_haptics/scene/files/obj.hpp>
#include <passive_haptics/scene/files/ply.hpp>
#include <passive_haptics/scene/files/stl.hpp>
#include <passive_haptics/scene/mesh/mesh_solid.hpp>
#include <passive_haptics/scene/mesh/mesh_surface.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/box.hpp>
#include <passive_haptics/scene/shapes/capsule.hpp>
#include <passive_haptics/scene/shapes/complement.hpp>
#include <passive_haptics/scene/shapes/convex_polygon.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/scene/shapes/offset.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace example {
namespace {

namespace ph = passive_haptics;
using ph::runtime::any_parameters;
using ph::runtime::any_shape;

// A shape of parameters P that make(p, of) makes; of: the shape that it is made of, or nullptr.
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

// Corners of a polygon, as many as there are.
struct corner_list {
  std::vector<ph::point<2>> corners;

  static constexpr auto members() {
    return ph::member_table(ph::member("corners", &corner_list::corners, "m", ph::range::finite));
  }
};

constexpr std::size_t max_corners = 8;

template <std::size_t K = 3>
any_shape<2> polygon_of(const std::vector<ph::point<2>>& corners) {
  if constexpr (K < max_corners)
    if (corners.size() > K) return polygon_of<K + 1>(corners);
  if (corners.size() != K)
    throw std::invalid_argument("number of corners of a convex_polygon = " + std::to_string(corners.size()) +
                                ", expected 3 to " + std::to_string(max_corners));
  ph::convex_polygon_parameters<int(K)> p;
  std::copy_n(corners.begin(), K, p.corners.begin());
  return any_shape<2>(ph::convex_polygon<int(K)>(p));
}

// A mesh of a file.
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
    throw std::invalid_argument("file = \"" + p.file + "\", expected a mesh, a .stl, .ply or .obj");
  ph::mesh_file found = read(p.file, p.metres_per_unit);
  for (auto& v : found.mesh.vertices) v += p.position;
  return ph::mesh<3>(std::move(found.mesh));
}

}  // namespace

// The shapes by name.
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
  };
  add.operator()<2>();
  add.operator()<3>();
  all.add_shape(entry_of<2, corner_list>(
      "convex_polygon", false, [](const auto& p, const any_shape<2>*) { return polygon_of(p.corners); }));
  all.add_shape(entry_of<3, mesh_file_parameters>(
      "mesh_solid", false, [](const auto& p, const any_shape<3>*) { return ph::mesh_solid<3>(mesh_of(p)); }));
  all.add_shape<3>({"mesh_surface", any_parameters(mesh_file_parameters()), false, nullptr,
                    [](const any_parameters& p, const any_shape<3>*, double stiffness) {
                      return ph::any_wall<3>(
                          ph::wall(ph::mesh_surface<3>(mesh_of(p.as<mesh_file_parameters>())), stiffness));
                    }});
}

}  // namespace example
