/// Dual numbers: forward-mode automatic differentiation.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <cmath>
#include <compare>
#include <concepts>
#include <type_traits>
#include <utility>

namespace passive_haptics {

/// A built-in arithmetic type.
template <class X>
concept PlainNumber = std::is_arithmetic_v<X>;

/// A number x and its derivatives dx by N variables: f(x, dx) = (f(x), f'(x) dx), exact to rounding. Supports
/// the operators and functions of `<cmath>` that have a derivative, by argument-dependent lookup: `using
/// std::cos; cos(x)`. Conversion to a plain number, as in std::cos(x), is a compile-time error because it
/// would drop the derivatives. Comparisons use only x.
template <class T, int N>
class dual_number {
 public:
  using derivative_vector = vector<T, N>;  ///< dx

  dual_number() : dual_number(T(0)) {}  ///< Zero.
  /// A constant: dx = 0.
  dual_number(PlainNumber auto x) : x_(static_cast<T>(x)), dx_(derivative_vector::Zero()) {}
  dual_number(T x, derivative_vector dx) : x_(x), dx_(std::move(dx)) {}  ///< Value and derivatives.
  /// Variable i of the N, with the value x.
  static dual_number variable(T x, int i) { return {x, derivative_vector::Unit(i)}; }

  T value() const { return x_; }                                ///< x
  const derivative_vector& derivatives() const { return dx_; }  ///< dx

  /// Fails with a short message. Implicit only to `long double`, the overload that std::cos(x) selects.
  template <PlainNumber X>
  explicit(!std::same_as<X, long double>) operator X() const {
    static_assert(!std::same_as<X, X>,
                  "passive_haptics: this drops the derivatives of position(q): write `using std::cos, "
                  "std::sin;` and then `cos(q[0])` instead of `std::cos(q[0])`, and `S x = q[0]` or `auto` "
                  "instead of `double x(q[0])`.");
    return static_cast<X>(x_);
  }

  /// (x)' = x'
  friend dual_number operator+(const dual_number& a) { return a; }
  /// (-x)' = -x'
  friend dual_number operator-(const dual_number& a) { return {-a.x_, -a.dx_}; }
  /// (x + y)' = x' + y'
  friend dual_number operator+(const dual_number& a, const dual_number& b) {
    return {a.x_ + b.x_, a.dx_ + b.dx_};
  }
  /// (x - y)' = x' - y'
  friend dual_number operator-(const dual_number& a, const dual_number& b) {
    return {a.x_ - b.x_, a.dx_ - b.dx_};
  }
  /// (x y)' = x' y + x y'
  friend dual_number operator*(const dual_number& a, const dual_number& b) {
    return {a.x_ * b.x_, a.dx_ * b.x_ + a.x_ * b.dx_};
  }
  /// (x / y)' = (x' - (x / y) y') / y
  friend dual_number operator/(const dual_number& a, const dual_number& b) {
    const T ratio = a.x_ / b.x_;
    return {ratio, (a.dx_ - ratio * b.dx_) / b.x_};
  }

  // Overloads for a constant c
  /// @cond
  friend dual_number operator+(const dual_number& a, PlainNumber auto c) { return {a.x_ + T(c), a.dx_}; }
  friend dual_number operator+(PlainNumber auto c, const dual_number& a) { return {T(c) + a.x_, a.dx_}; }
  friend dual_number operator-(const dual_number& a, PlainNumber auto c) { return {a.x_ - T(c), a.dx_}; }
  friend dual_number operator-(PlainNumber auto c, const dual_number& a) { return {T(c) - a.x_, -a.dx_}; }
  friend dual_number operator*(const dual_number& a, PlainNumber auto c) {
    return {a.x_ * T(c), a.dx_ * T(c)};
  }
  friend dual_number operator*(PlainNumber auto c, const dual_number& a) {
    return {T(c) * a.x_, T(c) * a.dx_};
  }
  friend dual_number operator/(const dual_number& a, PlainNumber auto c) {
    return {a.x_ / T(c), a.dx_ / T(c)};
  }
  friend dual_number operator/(PlainNumber auto c, const dual_number& a) { return dual_number(c) / a; }
  /// @endcond

  dual_number& operator+=(const dual_number& b) { return *this = *this + b; }  ///< x + y
  dual_number& operator-=(const dual_number& b) { return *this = *this - b; }  ///< x - y
  dual_number& operator*=(const dual_number& b) { return *this = *this * b; }  ///< x y
  dual_number& operator/=(const dual_number& b) { return *this = *this / b; }  ///< x / y

  // Comparisons of x
  /// @cond
  friend bool operator==(const dual_number& a, const dual_number& b) { return a.x_ == b.x_; }
  friend bool operator==(const dual_number& a, PlainNumber auto c) { return a.x_ == T(c); }
  friend auto operator<=>(const dual_number& a, const dual_number& b) { return a.x_ <=> b.x_; }
  friend auto operator<=>(const dual_number& a, PlainNumber auto c) { return a.x_ <=> T(c); }

  // Functions of <cmath>
  friend dual_number abs(const dual_number& a) { return a.x_ < T(0) ? -a : a; }
  friend dual_number fabs(const dual_number& a) { return abs(a); }
  friend dual_number sqrt(const dual_number& a) {
    const T root = std::sqrt(a.x_);
    return a.chain(root, T(0.5) / root);
  }
  friend dual_number cbrt(const dual_number& a) {
    const T root = std::cbrt(a.x_);
    return a.chain(root, T(1) / (T(3) * root * root));
  }
  friend dual_number exp(const dual_number& a) {
    const T power = std::exp(a.x_);
    return a.chain(power, power);
  }
  friend dual_number log(const dual_number& a) { return a.chain(std::log(a.x_), T(1) / a.x_); }
  friend dual_number sin(const dual_number& a) { return a.chain(std::sin(a.x_), std::cos(a.x_)); }
  friend dual_number cos(const dual_number& a) { return a.chain(std::cos(a.x_), -std::sin(a.x_)); }
  friend dual_number tan(const dual_number& a) {
    const T tangent = std::tan(a.x_);
    return a.chain(tangent, T(1) + tangent * tangent);
  }
  friend dual_number asin(const dual_number& a) {
    return a.chain(std::asin(a.x_), T(1) / std::sqrt(T(1) - a.x_ * a.x_));
  }
  friend dual_number acos(const dual_number& a) {
    return a.chain(std::acos(a.x_), T(-1) / std::sqrt(T(1) - a.x_ * a.x_));
  }
  friend dual_number atan(const dual_number& a) {
    return a.chain(std::atan(a.x_), T(1) / (T(1) + a.x_ * a.x_));
  }
  friend dual_number sinh(const dual_number& a) { return a.chain(std::sinh(a.x_), std::cosh(a.x_)); }
  friend dual_number cosh(const dual_number& a) { return a.chain(std::cosh(a.x_), std::sinh(a.x_)); }
  friend dual_number tanh(const dual_number& a) {
    const T tangent = std::tanh(a.x_);
    return a.chain(tangent, T(1) - tangent * tangent);
  }
  friend dual_number atan2(const dual_number& y, const dual_number& x) {
    const T square = x.x_ * x.x_ + y.x_ * y.x_;
    return {std::atan2(y.x_, x.x_), (x.x_ * y.dx_ - y.x_ * x.dx_) / square};
  }
  friend dual_number hypot(const dual_number& x, const dual_number& y) {
    const T length = std::hypot(x.x_, y.x_);
    return {length, (x.x_ / length) * x.dx_ + (y.x_ / length) * y.dx_};
  }
  friend dual_number pow(const dual_number& a, PlainNumber auto c) {
    return a.chain(std::pow(a.x_, T(c)), T(c) * std::pow(a.x_, T(c) - T(1)));
  }
  friend dual_number pow(const dual_number& a, const dual_number& b) { return exp(b * log(a)); }
  /// @endcond

 private:
  // Returns f and f' dx
  dual_number chain(T f, T slope) const { return {f, slope * dx_}; }

  T x_;
  derivative_vector dx_;
};

}  // namespace passive_haptics

/// @cond
// Scalars of Eigen's matrices.
template <class T, int N>
struct Eigen::NumTraits<passive_haptics::dual_number<T, N>> : Eigen::NumTraits<T> {
  using Real = passive_haptics::dual_number<T, N>;
  using NonInteger = passive_haptics::dual_number<T, N>;
  using Nested = passive_haptics::dual_number<T, N>;
  enum { RequireInitialization = 1 };
};
// Mixed operations give a dual number.
template <class T, int N, class Operation>
struct Eigen::ScalarBinaryOpTraits<passive_haptics::dual_number<T, N>, T, Operation> {
  using ReturnType = passive_haptics::dual_number<T, N>;
};
template <class T, int N, class Operation>
struct Eigen::ScalarBinaryOpTraits<T, passive_haptics::dual_number<T, N>, Operation> {
  using ReturnType = passive_haptics::dual_number<T, N>;
};
/// @endcond
