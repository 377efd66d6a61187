// Passive FMEs: the sign regions and what lies in them.
#include "../support.hpp"

#include <passive_haptics/brake/reference_forces.hpp>
#include <passive_haptics/design/fme_boundary.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <limits>

namespace {

constexpr auto two = ph::passive_fme_regions<2>();
static_assert(two.size() == 4);
static_assert(two[0] == ph::torque_signs<2>{1, 1} && two[1] == ph::torque_signs<2>{1, -1});
static_assert(two[2] == ph::torque_signs<2>{-1, 1} && two[3] == ph::torque_signs<2>{-1, -1});
static_assert(ph::passive_fme_regions<1>() == std::array{ph::torque_signs<1>{1}, ph::torque_signs<1>{-1}});

// Every region differs from every other.
template <int Brakes>
constexpr bool regions_are_distinct() {
  constexpr auto regions = ph::passive_fme_regions<Brakes>();
  for (std::size_t a = 0; a < regions.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (regions[a] == regions[b]) return false;
  return regions.size() == (1u << Brakes);
}
static_assert(regions_are_distinct<3>() && regions_are_distinct<5>());

template <class T>
struct passive_fme : ::testing::Test {
  using pair = ph::vector<T, 2>;
  const ph::tendon_two_link<T> arm;
  const pair q{T(1.9), T(-1.3)};
  const ph::matrix<T, 2, 2> E = ph::brake_jacobian(arm, q);
  const ph::matrix<T, 2, 2> G = ph::reference_forces(arm, q).G;
};
TYPED_TEST_SUITE(passive_fme, scalars);

TYPED_TEST(passive_fme, reference_forces_are_made_by_one_brake_alone) {
  using T = TypeParam;
  expect_near(ph::matrix<T, 2, 2>(this->E.transpose() * this->G),
              ph::matrix<T, 2, 2>(ph::matrix<T, 2, 2>::Identity()), this->E.norm() * this->G.norm());
  const auto reference = ph::reference_forces(this->arm, this->q);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(reference.positive(i), this->G.col(i)) << "R_" << i + 1 << "+";
    EXPECT_EQ(reference.negative(i), -this->G.col(i)) << "R_" << i + 1 << "-";
  }
}

TYPED_TEST(passive_fme, exactly_one_region_holds_a_generic_force) {
  using T = TypeParam;
  ph::testing::random_source random(11);
  for (int k = 0; k < 100; ++k) {
    const ph::vector<T, 2> t = random.uniform(T(0.01), T(0.99)) * random.direction<T, 2>();
    const ph::vector<T, 2> F = this->G * t;
    int holding = 0;
    for (const auto& region : two) {
      const bool here = ph::in_passive_fme(this->E, region, F);
      holding += here ? 1 : 0;
      EXPECT_EQ(here, static_cast<T>(region[0]) * t[0] > 0 && static_cast<T>(region[1]) * t[1] > 0)
          << t.transpose();
      EXPECT_FALSE(ph::in_passive_fme(this->E, region, ph::vector<T, 2>(F * (T(1.01) / t.norm()))))
          << "outside |t| = 1";
    }
    EXPECT_EQ(holding, 1) << "seed 11, t = " << t.transpose();
  }
}

TYPED_TEST(passive_fme, faces_belong_to_both_neighbours_and_the_origin_to_all) {
  using T = TypeParam;
  const ph::diagonal_matrix<T, 2> I(T(1), T(1));  // no rounding on the faces
  for (const auto& region : two) {
    EXPECT_TRUE(ph::in_passive_fme(I, region, ph::vector<T, 2>(0, 0)));
    EXPECT_EQ(ph::in_passive_fme(I, region, ph::vector<T, 2>(1, 0)), region[0] > 0) << "also on |t| = 1";
    EXPECT_EQ(ph::in_passive_fme(I, region, ph::vector<T, 2>(0, T(-0.5))), region[1] < 0);
  }
}

TYPED_TEST(passive_fme, torque_box_has_its_limits_as_corners) {
  using T = TypeParam;
  using V = ph::vector<T, 2>;
  const ph::diagonal_matrix<T, 2> I(T(1), T(1));
  const V limit(2, T(0.5));
  for (const auto& region : two) {
    const V corner(static_cast<T>(region[0]) * limit[0], static_cast<T>(region[1]) * limit[1]);
    EXPECT_TRUE(ph::in_torque_box(I, region, corner, limit));
    EXPECT_FALSE(ph::in_torque_box(I, region, V(corner[0] * T(1.001), corner[1]), limit));
    EXPECT_FALSE(ph::in_torque_box(I, region, V(corner[0], corner[1] * T(1.001)), limit));
    EXPECT_FALSE(ph::in_torque_box(I, region, V(-corner[0], corner[1]), limit));
    EXPECT_FALSE(ph::in_torque_box(I, region, V(corner[0], -corner[1]), limit));
  }
}

TYPED_TEST(passive_fme, outline_is_closed_and_its_arc_lies_on_unit_torque) {
  using T = TypeParam;
  EXPECT_EQ(ph::passive_fme_outline(this->G, two[0]).size(), 35u) << "32 chords if not given";
  for (const int bad : {0, std::numeric_limits<int>::max()})
    EXPECT_THROW(ph::passive_fme_outline(this->G, two[0], bad), std::invalid_argument);
  for (const auto& region : two) {
    const auto outline = ph::passive_fme_outline(this->G, region, 8);
    ASSERT_EQ(outline.size(), 11u);
    EXPECT_EQ(outline.front(), (ph::vector<T, 2>(0, 0)));
    EXPECT_EQ(outline.back(), outline.front());
    for (std::size_t k = 1; k + 1 < outline.size(); ++k) {
      const ph::vector<T, 2> t = this->E.transpose() * outline[k];
      EXPECT_NEAR(t.norm(), T(1), ph::rounding_tolerance<T>(16));
      EXPECT_GE(static_cast<T>(region[0]) * t[0], -ph::rounding_tolerance<T>(16));
      EXPECT_GE(static_cast<T>(region[1]) * t[1], -ph::rounding_tolerance<T>(16));
    }
    // From the reference force of brake 1 to that of brake 2
    const double size = static_cast<double>(this->G.norm());
    expect_near(outline[1], ph::vector<T, 2>(static_cast<T>(region[0]) * this->G.col(0)), size);
    expect_near(outline[9], ph::vector<T, 2>(static_cast<T>(region[1]) * this->G.col(1)), size);
  }
}

TYPED_TEST(passive_fme, torque_box_outline_is_a_parallelogram_over_the_limits) {
  using T = TypeParam;
  using V = ph::vector<T, 2>;
  const V limit(2, 3);
  for (const auto& region : two) {
    const auto outline = ph::torque_box_outline(this->G, region, limit);
    ASSERT_EQ(outline.size(), 5u);
    const V corners[] = {{0, 0}, {2, 0}, {2, 3}, {0, 3}, {0, 0}};
    for (std::size_t k = 0; k < 5; ++k) {
      const V t(static_cast<T>(region[0]) * corners[k][0], static_cast<T>(region[1]) * corners[k][1]);
      expect_near(V(this->E.transpose() * outline[k]), t,
                  static_cast<double>(this->E.norm() * outline[k].norm()) + 1e-30);
    }
  }
}

// x_i = q_i^2 / 2: singular where a joint is at 0.
template <class T>
struct parabola {
  using scalar = T;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  ph::vector<T, 2> position(const ph::vector<T, 2>& q) const { return q.cwiseAbs2() / T(2); }
  ph::matrix<T, 2, 2> jacobian(const ph::vector<T, 2>& q) const {
    return ph::matrix_of<2, 2>(q[0], T(0), T(0), q[1]);
  }
};

TYPED_TEST(passive_fme, generators_are_no_numbers_where_the_jacobian_is_singular) {
  using T = TypeParam;
  const auto generators = ph::force_generators(parabola<T>(), ph::vector<T, 2>(T(2), T(-4)));
  expect_near(generators, ph::matrix_of<2, 2>(T(0.5), T(0), T(0), T(-0.25)), 1);
  EXPECT_FALSE(ph::force_generators(parabola<T>(), ph::vector<T, 2>(T(2), T(0))).allFinite());
  const ph::matrix<T, 2, 2> rank_one = ph::matrix_of<2, 2>(T(1), T(2), T(2), T(4));
  EXPECT_TRUE((ph::pseudo_inverse<T, 2, 2>(rank_one).array().isNaN().all()));
  const ph::matrix<T, 3, 2> tall = ph::matrix_of<3, 2>(T(1), T(2), T(0), T(3), T(-1), T(4));
  expect_near(ph::matrix<T, 2, 2>(ph::pseudo_inverse<T, 3, 2>(tall) * tall),
              ph::matrix<T, 2, 2>(ph::matrix<T, 2, 2>::Identity()), 10);
}

TYPED_TEST(passive_fme, reference_forces_say_where_there_are_none) {
  using T = TypeParam;
  const auto straight = ph::reference_forces(ph::two_link<T>(), ph::vector<T, 2>(T(0.5), T(0)));
  EXPECT_EQ(straight.outcome, ph::status::singular_jacobian);
  EXPECT_TRUE(straight.G.array().isNaN().all());
  const T nan = std::numeric_limits<T>::quiet_NaN();
  const auto nowhere = ph::reference_forces(ph::two_link<T>(), ph::vector<T, 2>(T(0.5), nan));
  EXPECT_EQ(nowhere.outcome, ph::status::pose_undefined);
  EXPECT_TRUE(nowhere.G.array().isNaN().all());
  const auto table = ph::reference_forces(ph::xy_table<T>(), ph::vector<T, 2>(T(0.5), T(0)));
  EXPECT_EQ(table.outcome, ph::status::ok);
  EXPECT_EQ(table.G, (ph::matrix<T, 2, 2>::Identity()));
}

}  // namespace
