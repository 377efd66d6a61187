/// First-order response of a brake, a filter or a sensor.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace passive_haptics {

/// Share of a step of u that T dy/dt + y = u covers in dt [s]: 1 - exp(-dt / T); 1 if T = 0.
template <class T>
T lag_share(T dt, T time_constant) {
  return time_constant > T(0) ? -std::expm1(-dt / time_constant) : T(1);
}

/// Returns y after dt [s] with a constant input u; exactly u if T = 0 or dt is infinite or NaN.
template <class T>
T lagged(T y, T u, T dt, T time_constant) {
  if (!(time_constant > T(0)) || !(dt < std::numeric_limits<T>::infinity())) return u;
  return y + lag_share(dt, time_constant) * (u - y);
}

/// Lag T_b dy/dt + y = u with a time constant for each of N channels, exact for u constant over a step.
template <class T, int N>
class first_order_lag {
 public:
  /// Time constants [s]; 0 means no lag. Starts at y = 0.
  explicit first_order_lag(const vector<T, N>& time_constant) : time_constant_(time_constant) {}

  /// Returns y after dt [s] of constant input u.
  const vector<T, N>& advance(T dt, const vector<T, N>& u) {
    for (int i = 0; i < N; ++i) y_[i] = lagged(y_[i], u[i], dt, time_constant_[i]);
    return y_;
  }

  const vector<T, N>& output() const { return y_; }  ///< Current y.

 private:
  vector<T, N> time_constant_;
  vector<T, N> y_ = vector<T, N>::Zero();
};

/// Time constant [s] of a first-order low-pass with this corner frequency [Hz]; 0 if the corner is 0.
template <class T>
T low_pass_time_constant(T corner) {
  return corner > T(0) ? T(1) / (T(2) * std::numbers::pi_v<T> * corner) : T(0);
}

}  // namespace passive_haptics
