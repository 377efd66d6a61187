/// @file
/// A force sensor at the handle: a low-pass, a scale and noise.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/core/scalar/first_order_lag.hpp>
#include <passive_haptics/plant/random_numbers.hpp>

#include <cstdint>
#include <random>

namespace passive_haptics {

/// Bandwidth, scale and noise of a force sensor.
struct force_sensor_parameters {
  double corner = 200;     ///< First-order low-pass [Hz]; 0 for none.
  double noise = 0;        ///< Standard deviation of each component of each reading [N].
  std::uint64_t seed = 1;  ///< Of the noise; the same seed gives the same noise on every platform.
  double scale = 1;        ///< Reading for each newton [1]; 1 is a sensor calibrated without error.

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = force_sensor_parameters;
    return member_table(member("corner", &p::corner, "Hz", range::not_negative),
                        member("noise", &p::noise, "N", range::not_negative), member("seed", &p::seed),
                        member("scale", &p::scale, "1", range::positive));
  }
};

/// Force sensor with D components. The low-pass follows the force in time; scale and white noise join each
/// reading behind it, so two readings share none. Starts at no force.
template <class T, int D>
class force_sensor {
 public:
  /// Throws std::invalid_argument with the text of validate(p).
  explicit force_sensor(const force_sensor_parameters& p = {})
      : low_pass_(vector<T, D>::Constant(low_pass_time_constant(static_cast<T>(require_valid(p).corner)))),
        scale_(static_cast<T>(p.scale)),
        noise_(p.noise),
        bits_(p.seed) {}

  /// dt [s] pass under this force [N].
  void advance(T dt, const vector<T, D>& force) { low_pass_.advance(dt, force); }

  /// One reading [N], with noise of its own.
  vector<T, D> read() {
    vector<T, D> reading = scale_ * low_pass_.output();
    if (!(noise_ > 0)) return reading;
    for (int i = 0; i < D; ++i) reading[i] += static_cast<T>(noise_ * normal_number(bits_));
    return reading;
  }

  /// Behind the low-pass, without scale and noise [N].
  const vector<T, D>& filtered() const { return low_pass_.output(); }

 private:
  first_order_lag<T, D> low_pass_;
  T scale_;
  double noise_;
  std::mt19937_64 bits_;
};

}  // namespace passive_haptics
