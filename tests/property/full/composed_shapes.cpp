#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/testing/shape_properties.hpp>

#include "../user_shapes.hpp"

namespace ph = passive_haptics;
using namespace passive_haptics::testing;

template <class Shape, int Size = 2>
struct around_origin {
  using shape = Shape;
  static ph::point<shape::dimension> lower() { return ph::point<shape::dimension>::Constant(-Size); }
  static ph::point<shape::dimension> upper() { return ph::point<shape::dimension>::Constant(Size); }
};

inline ph::matrix<double, 2, 2> turned(double angle) {
  return (ph::matrix<double, 2, 2>() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle))
      .finished();
}

template <int D>
struct capsule_case : around_origin<ph::capsule<D>> {
  static ph::capsule<D> make() {
    return ph::capsule<D>(ph::point<D>::LinSpaced(-0.6, 0.4), ph::point<D>::LinSpaced(0.9, 0.1), 0.25);
  }
};

struct short_capsule_case : around_origin<ph::capsule<3>> {
  static ph::capsule<3> make() { return ph::capsule<3>({0.1, 0.2, 0.3}, {0.1, 0.2, 0.3}, 0.5); }
};

template <int D>
struct box_case : around_origin<ph::box<D>> {
  static ph::box<D> make() {
    return ph::box<D>(ph::point<D>::Constant(0.1), ph::point<D>::LinSpaced(0.5, 1.0));
  }
};

struct turned_box_case : around_origin<ph::box<2>> {
  static ph::box<2> make() { return ph::box<2>(ph::box_parameters<2>{{0.1, -0.2}, {0.8, 0.4}, turned(0.5)}); }
};

struct plate_case : around_origin<ph::box<3>> {
  static ph::box<3> make() { return ph::box<3>({0, 0, 0}, {0.5, 0, 0.8}); }
};

struct polygon_case : around_origin<ph::convex_polygon<5>> {
  static shape make() { return shape({{-0.9, -0.5}, {0.2, -0.8}, {0.9, 0.1}, {0.3, 0.9}, {-0.7, 0.6}}); }
};

struct plane_polytope_case : around_origin<ph::convex_polytope<2, 4>> {
  static shape make() {
    using face = ph::half_space<2>;
    return shape(face({0.7, 0}, {1, 0.2}), face({0, 0.8}, {-0.3, 1}), face({-0.9, 0}, {-1, 0.1}),
                 face({0, -0.6}, {0.1, -1}));
  }
};

struct tetrahedron_case : around_origin<ph::convex_polytope<3, 4>> {
  static shape make() {
    using face = ph::half_space<3>;
    return shape(face({0, 0, -0.4}, {0, 0, -1}), face({0.3, 0.3, 0}, {1, 1, 0.5}),
                 face({-0.3, 0.3, 0}, {-1, 1, 0.5}), face({0, -0.4, 0}, {0, -1, 0.5}));
  }
};

struct rounded_box_case : around_origin<ph::offset<ph::box<3>>> {
  static shape make() { return shape(box_case<3>::make(), 0.2); }
};

struct shrunk_polygon_case : around_origin<ph::offset<ph::convex_polygon<5>>> {
  static shape make() { return shape(polygon_case::make(), -0.2); }
};

struct hollow_case : around_origin<ph::complement<ph::capsule<2>>> {
  static shape make() { return shape(capsule_case<2>::make()); }
};

struct nested_case : around_origin<ph::complement<ph::offset<ph::moving<ph::box<2>>>>> {
  static shape make() {
    ph::moving carried(turned_box_case::make());
    carried.set_motion({0.3, 0.1}, {1, 2});
    return shape(ph::offset(carried, 0.1));
  }
};

struct torus_case : around_origin<custom::torus> {
  static custom::torus make() { return custom::torus(1.0, 0.3); }
};

struct either_case : around_origin<ph::offset<custom::either<ph::disc, ph::rectangle>>> {
  static shape make() {
    return shape(custom::either(ph::disc({-0.7, 0}, 0.4), ph::rectangle({0.7, 0}, {0.2, 0.6})), 0.1);
  }
};

struct ball_case : around_origin<ph::ball<3>> {
  static ph::ball<3> make() { return ph::ball<3>({0.1, 0.2, 0.3}, 0.5, ph::filling::hollow); }
};

struct half_space_case : around_origin<ph::half_space<2>> {
  static ph::half_space<2> make() { return ph::half_space<2>({0.1, 0.2}, {3, -4}); }
};

using shape_cases =
    ::testing::Types<half_space_case, ball_case, capsule_case<2>, capsule_case<3>, short_capsule_case,
                     box_case<2>, box_case<3>, turned_box_case, plate_case, polygon_case, plane_polytope_case,
                     tetrahedron_case, rounded_box_case, shrunk_polygon_case, hollow_case, nested_case,
                     torus_case, either_case>;

INSTANTIATE_TYPED_TEST_SUITE_P(shapes, shape_properties, shape_cases);
