#include "parts.hpp"

#include <passive_haptics/core/linear/cholesky.hpp>

#include <algorithm>
#include <cmath>

namespace explorer {
namespace {

// Damped steps q += J^T (J J^T + l^2 1)^-1 e, with the damping l of the size of the error e. Steps that do
// not help are halved.
runtime::any_mechanism::joint_pose inverse_by_steps(const device_parts& of, const place& x, numbers from) {
  constexpr int max_steps = 60;
  constexpr double exactness = 1e-9, max_step = 0.3;  // of the reach [1], [rad]
  const double size = of.settings.about->reach(of.settings.mechanism);
  const std::size_t n = std::size_t(of.n());
  joint_numbers q(from);
  if (!x.allFinite()) return {q, ph::status::state_not_finite, true};
  place e = x - of.position(q);
  double step = 1;
  for (int k = 0; k < max_steps && e.norm() > exactness * size && step > 1e-6; ++k) {
    const auto J = of.jacobian(q);
    const double damping = std::min(0.1 * size, e.norm());
    ph::matrix<double, 3, 3> A = damping * damping * ph::matrix<double, 3, 3>::Identity();
    for (std::size_t j = 0; j < n; ++j) A += J[j] * J[j].transpose();
    const place drive = ph::cholesky<double, 3>(A).solve(e);
    joint_numbers next = q;
    double length = 0;
    for (std::size_t j = 0; j < n; ++j) length = std::hypot(length, J[j].dot(drive));
    const double share = step * std::min(1.0, max_step / length);
    for (std::size_t j = 0; j < n; ++j) next.values[j] += share * J[j].dot(drive);
    const place left = x - of.position(next);
    const bool helps = left.norm() < e.norm();
    if (helps) q = next, e = left;
    step = helps ? std::min(1.0, 2 * step) : step / 2;
  }
  return {q, e.norm() <= exactness * size ? ph::status::ok : ph::status::out_of_reach, true};
}

}  // namespace

device_parts::device_parts(const configuration& given)
    : settings(given),
      mechanism(settings.make_mechanism()),
      kind(kind_of(*mechanism)),
      wall(settings.state.scene, settings.sizes.task_dimension) {
  if (!position(settings.state.q).allFinite())
    refuse("q", text_of(*find(settings.fields(), "q")),
           "joint positions at which the chain closes; change q or the lengths");
}

place device_parts::velocity(numbers q, numbers qd) const {
  const auto J = jacobian(q);
  place v = place::Zero();
  for (int j = 0; j < n(); ++j) v += qd[std::size_t(j)] * J[std::size_t(j)];
  return v;
}

std::array<place, runtime::max_joints> device_parts::jacobian(numbers q) const {
  std::array<double, 3 * runtime::max_joints> J{};
  mechanism->jacobian(q, J);
  std::array<place, runtime::max_joints> columns;
  for (int j = 0; j < n(); ++j) {
    const double* column = J.data() + j * d();
    columns[std::size_t(j)] = place(column[0], column[1], d() == 3 ? column[2] : 0.0);
  }
  return columns;
}

runtime::any_mechanism::joint_pose device_parts::inverse(const place& x, numbers from) const {
  const auto branch = n() == 2 && std::sin(from[1]) > 0 ? ph::elbow::right : ph::elbow::left;
  const auto solved = mechanism->solve(first(x, d()), branch);
  return solved.has_inverse ? solved : inverse_by_steps(*this, x, from);
}

void device_parts::require_wall_for_hand() const {
  if (settings.state.hand == hand_kind::along && !wall)
    refuse("hand", "along", "pointer, where there is no wall: scene=none");
}

}  // namespace explorer
