/// A force sensor at the handle with low-pass, scale and noise.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/core/scalar/first_order_lag.hpp>
#include <passive_haptics/plant/random_numbers.hpp>

#include <cstdint>
#include <random>

namespace passive_haptics {

/// Parameters of force_sensor.
struct force_sensor_parameters {
  double corner = 200;     ///< First-order low-pass [Hz]; 0 for none.
  double noise = 0;        ///< Standard deviation of each component [N].
  std::uint64_t seed = 1;  ///< Seed of the noise, reproducible on every platform.
  double scale = 1;        ///< Reading per newton [1]; 1 without calibration error.

  static constexpr auto members() {
    using p = force_sensor_parameters;
    return member_table(member("corner", &p::corner, "Hz", range::not_negative),
                        member("noise", &p::noise, "N", range::not_negative), member("seed", &p::seed),
                        member("scale", &p::scale, "1", range::positive));
  }
};

/// Force sensor with D components. The low-pass follows the force; scale and white noise are added to each
/// reading independently. Starts at zero force.
template <class T, int D>
class force_sensor {
 public:
  /// Throws std::invalid_argument with the text of validate(p).
  explicit force_sensor(const force_sensor_parameters& p = {})
      : low_pass_(vector<T, D>::Constant(low_pass_time_constant(static_cast<T>(require_valid(p).corner)))),
        scale_(static_cast<T>(p.scale)),
        noise_(p.noise),
        bits_(p.seed) {}

  /// Advances by dt [s] under this force [N].
  void advance(T dt, const vector<T, D>& force) { low_pass_.advance(dt, force); }

  /// One reading [N] with new noise.
  vector<T, D> read() {
    vector<T, D> reading = scale_ * low_pass_.output();
    if (!(noise_ > 0)) return reading;
    for (int i = 0; i < D; ++i) reading[i] += static_cast<T>(noise_ * normal_number(bits_));
    return reading;
  }

  /// Force after the low-pass, without scale and noise [N].
  const vector<T, D>& filtered() const { return low_pass_.output(); }

 private:
  first_order_lag<T, D> low_pass_;
  T scale_;
  double noise_;
  std::mt19937_64 bits_;
};

}  // namespace passive_haptics
