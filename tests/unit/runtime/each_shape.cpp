// no sanitizers
// Each shape and effect of examples/catalogue makes the cycles of the shape or effect itself.
#include "pairs.hpp"

#include <catalogue/catalogue.hpp>

#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/scene/files/obj.hpp>
#include <passive_haptics/scene/mesh/height_field.hpp>
#include <passive_haptics/scene/mesh/mesh_solid.hpp>
#include <passive_haptics/scene/mesh/mesh_surface.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/box.hpp>
#include <passive_haptics/scene/shapes/capsule.hpp>
#include <passive_haptics/scene/shapes/complement.hpp>
#include <passive_haptics/scene/shapes/convex_polygon.hpp>
#include <passive_haptics/scene/shapes/convex_polytope.hpp>
#include <passive_haptics/scene/shapes/offset.hpp>
#include <passive_haptics/scene/world/world.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string_view>

namespace {

constexpr double stiffness = 1e4;

// Device M under direct_control, with walls by name and made here.
template <class M>
class device {
  static constexpr int d = M::task_dimension;

 public:
  explicit device(const char* name) : name_(name), motion_(random_motion(M(), 400)) {}

  // Where the handle is at first.
  ph::point<d> start() const { return own_.position(motion_[0].q); }

  template <class S>
  void expect_same_cycles(const char* shape, const rt::any_parameters& parameters, const S& own,
                          const rt::any_shape<d>* of = nullptr) {
    SCOPED_TRACE(shape);
    seen_.insert(shape);
    const auto& all = example::catalogue();
    const rt::shape_entry<d>& entry = *rt::find(all.shapes<d>(), shape);
    EXPECT_EQ(entry.takes_shape, of != nullptr);
    compare(ph::any_wall<d>(ph::wall(own, stiffness)), entry.make_wall(parameters, of, stiffness));
    if (entry.make) {
      const rt::any_shape<d> made = entry.make(parameters, of);
      if constexpr (ph::Shape<S>) {
        EXPECT_EQ(made.distance(start()), own.distance(start()));
      }
    }
  }

  void expect_all_seen() const {
    for (const auto& entry : example::catalogue().shapes<d>())
      EXPECT_TRUE(seen_.contains(entry.name)) << entry.name;
  }

 private:
  void compare(const ph::any_wall<d>& own, const ph::any_wall<d>& by_name) {
    const auto& all = example::catalogue();
    const auto& mechanism = *rt::find(all.mechanisms(), name_);
    const auto& law = *rt::find(all.laws(), "direct_control");
    const auto world_of = [](const ph::any_wall<d>& w) {
      ph::world_walls<d> walls;
      walls.add(w);
      return ph::world<d>(walls);
    };
    ph::controller direct(own_, ph::switchable_brakes<M>(), world_of(own), ph::direct_control());
    const auto any = all.make_controller(
        *mechanism.make(mechanism.defaults), law,
        {rt::brake_numbers(M::brake_count), rt::any_scene<d>(world_of(by_name)), law.defaults});
    int touched = 0;
    for (const auto& state : motion_) {
      const rt::cycle_record expected(direct(state));
      touched += expected.wall_number == 0;
      ASSERT_TRUE(same((*any)(view_of(state)), expected));
    }
    EXPECT_GT(touched, 20);
  }

  const char* name_;
  M own_;
  std::vector<ph::device_state<M>> motion_;
  std::set<std::string> seen_;
};

template <int D, class Device>
void expect_solids(Device& in) {
  const ph::point<D> x = in.start();
  const auto ball = ph::ball_parameters<D>{.centre = x, .radius = 0.1};
  const ph::half_space_parameters<D> plane{x, ph::point<D>::UnitY()};
  const ph::box_parameters<D> box{.centre = x, .half_extents = ph::point<D>::Constant(0.08)};
  const ph::capsule_parameters<D> bar{.from = x, .to = x + 0.1 * ph::point<D>::UnitX(), .radius = 0.05};
  in.expect_same_cycles("half_space", rt::any_parameters(plane), ph::half_space<D>(plane));
  in.expect_same_cycles("ball", rt::any_parameters(ball), ph::ball<D>(ball));
  in.expect_same_cycles("box", rt::any_parameters(box), ph::box<D>(box));
  in.expect_same_cycles("capsule", rt::any_parameters(bar), ph::capsule<D>(bar));
  const rt::any_shape<D> of{ph::ball<D>(ball)};
  in.expect_same_cycles("offset", rt::any_parameters(ph::offset_parameters{0.02}),
                        ph::offset(ph::ball<D>(ball), 0.02), &of);
  in.expect_same_cycles("complement", rt::any_parameters(), ph::complement(ph::ball<D>(ball)), &of);
}

rt::field& field_of(rt::field_list& all, std::string_view name) {
  for (rt::field& f : all)
    if (name == f.about.name) return f;
  throw std::logic_error("no such field");
}

rt::any_parameters triangle(const ph::point<2> (&corners)[3]) {
  rt::any_parameters p = rt::find(example::catalogue().shapes<2>(), "convex_polygon")->defaults;
  rt::field_list all = p.fields();
  rt::field& list = field_of(all, "corners");
  double* to = list.resize(list.at, 3);
  for (const auto& c : corners) to = std::copy_n(c.data(), 2, to);
  return p;
}

template <int D, std::size_t K>
rt::any_parameters faces_of(const std::array<ph::half_space_parameters<D>, K>& faces) {
  rt::any_parameters p = rt::find(example::catalogue().shapes<D>(), "convex_polytope")->defaults;
  rt::field_list all = p.fields();
  const rt::field& list = field_of(all, "faces");
  auto tables = list.resize_tables(list.at, K);
  for (std::size_t k = 0; k < K; ++k) {
    std::copy_n(faces[k].surface_point.data(), D, field_of(tables[k], "surface_point").numbers());
    std::copy_n(faces[k].normal.data(), D, field_of(tables[k], "normal").numbers());
  }
  return p;
}

// A corner upward, around the start.
template <int D, class Device>
void expect_polytope(Device& in) {
  constexpr int K = 2 * (D - 1);
  ph::convex_polytope_parameters<D, K> p;
  for (int k = 0; k < K; ++k) {
    ph::half_space_parameters<D>& face = p.faces[static_cast<std::size_t>(k)];
    face = {in.start() + 0.05 * ph::point<D>::UnitY(), 2 * ph::point<D>::UnitY()};
    face.normal[k < 2 ? 0 : 2] = k % 2 == 0 ? 1 : -1;
  }
  in.expect_same_cycles("convex_polytope", faces_of(p.faces), ph::convex_polytope<D, K>(p));
}

// A pyramid of this size [m] in a file, with its base up.
struct pyramid_file {
  pyramid_file() : path(::testing::TempDir() + "pyramid.obj") {
    std::ofstream(path) << "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv 0 0 -1\n"
                           "f 1 2 3 4\nf 2 1 5\nf 3 2 5\nf 4 3 5\nf 1 4 5\n";
  }
  ~pyramid_file() { std::remove(path.c_str()); }
  rt::any_parameters at(const char* shape, const ph::point<3>& position) const {
    rt::any_parameters p = rt::find(example::catalogue().shapes<3>(), shape)->defaults;
    rt::field_list all = p.fields();
    field_of(all, "file").text() = path;
    *field_of(all, "metres_per_unit").numbers() = 0.1;
    std::copy_n(position.data(), 3, field_of(all, "position").numbers());
    return p;
  }
  ph::mesh<3> mesh_at(const ph::point<3>& position) const {
    auto read = ph::read_obj(path, 0.1);
    for (auto& v : read.mesh.vertices) v += position;
    return ph::mesh<3>(std::move(read.mesh));
  }
  std::string path;
};

TEST(catalogue, each_shape_in_the_plane_has_its_own_cycles) {
  device<ph::tendon_two_link<double>> arm("tendon_two_link");
  expect_solids<2>(arm);
  const ph::point<2> x = arm.start(), a(0.1, 0), b(0, 0.1);
  const ph::point<2> corners[] = {x - a - b, x + a, x + b};
  arm.expect_same_cycles("convex_polygon", triangle(corners), ph::convex_polygon(corners));
  expect_polytope<2>(arm);
  arm.expect_all_seen();
}

TEST(catalogue, each_shape_in_space_has_its_own_cycles) {
  device<ph::delta<double>> delta("delta");
  expect_solids<3>(delta);
  const pyramid_file file;
  const ph::point<3> x = delta.start();
  delta.expect_same_cycles("mesh_solid", file.at("mesh_solid", x), ph::mesh_solid<3>(file.mesh_at(x)));
  delta.expect_same_cycles("mesh_surface", file.at("mesh_surface", x), ph::mesh_surface<3>(file.mesh_at(x)));
  expect_polytope<3>(delta);

  const ph::height_field_parameters field{.columns = 3,
                                          .rows = 2,
                                          .spacing_x = 0.2,
                                          .spacing_y = 0.5,
                                          .heights = {0.01, 0, -0.01, 0.02, 0.003, 0},
                                          .origin = x - ph::point<3>(0.2, 0.25, 0)};
  const std::string path = ::testing::TempDir() + "heights.csv";
  std::ofstream(path) << "10, 0, -10\n\n2e1 3\t0\n";
  rt::any_parameters p = rt::find(example::catalogue().shapes<3>(), "height_field")->defaults;
  rt::field_list all = p.fields();
  field_of(all, "file").text() = path;
  *field_of(all, "spacing_x").numbers() = field.spacing_x;
  *field_of(all, "spacing_y").numbers() = field.spacing_y;
  std::copy_n(field.origin.data(), 3, field_of(all, "origin").numbers());
  delta.expect_same_cycles("height_field", p, ph::mesh_surface<3>(ph::mesh<3>(ph::height_field(field))));
  std::remove(path.c_str());
  delta.expect_all_seen();
}

}  // namespace
