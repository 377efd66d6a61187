// slow, together
#include <gtest/gtest.h>
#include <passive_haptics/driver/calibration/force_calibration.hpp>
#include <passive_haptics/driver/calibration/steady_mean.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <Eigen/Geometry>

#include <numbers>

namespace ph = passive_haptics;
using ph::testing::random_source;

namespace {

template <int D>
ph::matrix<double, D, D> random_rotation(random_source& random) {
  if constexpr (D == 2) {
    return Eigen::Rotation2D<double>(random.uniform(-4.0, 4.0)).toRotationMatrix();
  } else {
    const ph::vector<double, 4> x = random.direction<double, 4>();
    return Eigen::Quaterniond(x[0], x[1], x[2], x[3]).toRotationMatrix();
  }
}

// A sensor: raw values = strain (force on it in its frame + offset), and a calibration that undoes the
// strains
template <int D, int Channels>
struct modelled {
  ph::matrix<double, Channels, D> strain;
  ph::vector<double, D> offset;
  ph::force_calibration_parameters<D, Channels> p;

  explicit modelled(random_source& random) {
    // Orthogonal columns of like lengths, so that the test measures this code and no condition number
    const Eigen::MatrixXd some =
        Eigen::MatrixXd::NullaryExpr(Channels, D, [&] { return random.normal<double>(); });
    const Eigen::MatrixXd columns = Eigen::HouseholderQR<Eigen::MatrixXd>(some).householderQ();
    ph::vector<double, D> length;
    for (int i = 0; i < D; ++i) length[i] = random.positive(0.5, 2.0);
    strain = columns.leftCols(D) * length.asDiagonal();
    p.newtons_per_unit = length.cwiseInverse().asDiagonal() * columns.leftCols(D).transpose();
    offset = 10 * random.normal_vector<double, D>();
    p.handle_mass = random.uniform(0.0, 0.5);
    p.gravity = 9.81 * random.direction<double, D>();
  }
  ph::vector<double, Channels> read(const ph::vector<double, D>& hand,
                                    const ph::matrix<double, D, D>& R) const {
    return strain * (R.transpose() * (hand + p.handle_mass * p.gravity) + offset);
  }
};

template <int D, int Channels>
double max_residual() {
  double worst = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    random_source random(seed);
    const modelled<D, Channels> sensor(random);
    ph::force_calibration<D, Channels> calibration(sensor.p);
    const auto tare_pose = random_rotation<D>(random);
    calibration.set_tare(
        calibration.tare_of(sensor.read(ph::vector<double, D>::Zero(), tare_pose), tare_pose));
    for (int k = 0; k < 20; ++k) {
      const auto R = random_rotation<D>(random);
      const ph::vector<double, D> hand = 30 * random.normal_vector<double, D>();
      const double scale = hand.norm() + sensor.offset.norm() + 9.81 * sensor.p.handle_mass;
      worst = std::max(worst, (calibration.force(sensor.read(hand, R), R) - hand).norm() / scale);
    }
  }
  return worst;
}

TEST(force_calibration, finds_the_force_of_the_hand_in_any_pose_after_a_tare_in_another) {
  for (const double residual : {max_residual<2, 2>(), max_residual<3, 6>()}) EXPECT_LE(residual, 1e-14);
}

TEST(force_calibration, reads_newtons_of_the_first_channels_and_turns_with_the_last_link) {
  using vec = ph::vector<double, 2>;
  const double half_pi = std::numbers::pi / 2;
  const ph::force_calibration<2, 6> calibration;
  const auto off = [&](const ph::planar_sensor_frame<2>& frame, const vec& q, const vec& expected) {
    ph::vector<double, 6> raw;
    raw << 1, 0, 50, 60, 70, 80;
    return (calibration.force(raw, frame(q)) - expected).norm();
  };
  // Along the sensor's x axis; the second angle is measured from link 1, from the base; mounted across
  EXPECT_LT(off({.link = {1, 1}}, {half_pi, half_pi}, {-1, 0}), 1e-15);
  EXPECT_LT(off({.link = {0, 1}}, {1.234, half_pi}, {0, 1}), 1e-15);
  EXPECT_LT(off({.link = {1, 1}, .mounting = -half_pi}, {0, half_pi}, {1, 0}), 1e-15);
}

TEST(force_calibration, tares_over_noise_while_the_handle_hangs_still) {
  random_source random(1);
  const modelled<2, 2> sensor(random);
  ph::force_calibration<2> calibration(sensor.p);
  const auto R = random_rotation<2>(random);
  ph::steady_mean<2> readings({.duration = 1, .tolerance = 5});
  for (int k = 0; readings.status() != ph::steady_status::done && k < 5000; ++k)
    readings.add(1e-3 * k,
                 sensor.read(ph::vector<double, 2>::Zero(), R) + 0.1 * random.normal_vector<double, 2>());
  calibration.set_tare(calibration.tare_of(readings.mean(), R));
  const double worst_gain = sensor.p.newtons_per_unit.norm();
  EXPECT_LT((calibration.tare() - sensor.offset).norm(), worst_gain * 5 * 0.1 / std::sqrt(1000));
}

TEST(force_calibration, keeps_its_tare_if_the_new_one_is_no_number) {
  ph::force_calibration<2> calibration;
  calibration.set_tare({1, 2});
  calibration.set_tare({NAN, 0});
  EXPECT_EQ(calibration.tare(), (ph::vector<double, 2>(1, 2)));
}

TEST(force_calibration, names_what_is_wrong) {
  using parameters = ph::force_calibration_parameters<2, 3>;
  const auto error = [](auto change) {
    parameters p;
    change(p);
    return validate(p);
  };
  EXPECT_EQ(error([](parameters&) {}), "");
  EXPECT_EQ(error([](parameters& p) { p.handle_mass = -1; }),
            "handle_mass [kg] = -1: expected a finite number >= 0");
  EXPECT_EQ(error([](parameters& p) { p.tare[1] = NAN; }), "tare[1] [N] = nan: expected a finite number");
  EXPECT_EQ(error([](parameters& p) { p.gravity[0] = INFINITY; }),
            "gravity[0] [m/s^2] = inf: expected a finite number");
  EXPECT_EQ(error([](parameters& p) { p.newtons_per_unit(1, 2) = NAN; }),
            "newtons_per_unit(1, 2) [N] = nan: expected a finite number");
  EXPECT_EQ(
      error([](parameters& p) { p.gravity = {0, -9.81}; }),
      "handle_mass [kg] = 0: expected > 0 if gravity is given, as gravity acts on nothing else; weigh the "
      "handle, or remove gravity");
  EXPECT_EQ(error([](parameters& p) { p.gravity = {0, -9.81}, p.handle_mass = 0.2; }), "");
  EXPECT_EQ(
      error([](parameters& p) { p.newtons_per_unit.row(1) = p.newtons_per_unit.row(0); }),
      "newtons_per_unit has dependent rows: expected independent rows: measure each direction by itself");
}

}  // namespace
