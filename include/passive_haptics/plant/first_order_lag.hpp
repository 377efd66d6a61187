/// @file
/// First-order response of a brake, a filter or a sensor.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <cmath>
#include <numbers>

namespace passive_haptics {

/// T_b dy/dt + y = u, one time constant for each of N channels, solved exactly for u constant over a step.
template <class T, int N>
class first_order_lag {
 public:
  /// Time constants [s]; 0 follows at once. Starts at y = 0.
  explicit first_order_lag(const vector<T, N>& time_constant) : time_constant_(time_constant) {}

  /// y after dt [s] of constant input u.
  const vector<T, N>& advance(T dt, const vector<T, N>& u) {
    for (int i = 0; i < N; ++i) {
      if (time_constant_[i] > T(0)) y_[i] -= std::expm1(-dt / time_constant_[i]) * (u[i] - y_[i]);
      else y_[i] = u[i];
    }
    return y_;
  }

  /// y now.
  const vector<T, N>& output() const { return y_; }

 private:
  vector<T, N> time_constant_;
  vector<T, N> y_ = vector<T, N>::Zero();
};

/// Time constant [s] of a first-order low-pass with this corner frequency [Hz].
template <class T>
T low_pass_time_constant(T corner) {
  return T(1) / (T(2) * std::numbers::pi_v<T> * corner);
}

}  // namespace passive_haptics
