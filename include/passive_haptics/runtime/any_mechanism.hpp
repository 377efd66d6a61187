/// Mechanisms chosen at run time.
#pragma once

#include <passive_haptics/brake/models/encoder_axes.hpp>
#include <passive_haptics/mechanism/models/inverse_kinematics.hpp>
#include <passive_haptics/runtime/cycle_record.hpp>
#include <passive_haptics/runtime/mechanism_of_kind.hpp>

#include <algorithm>
#include <memory>
#include <type_traits>
#include <typeindex>
#include <utility>

namespace passive_haptics::runtime {

/// A mechanism by virtual functions. Spans have the sizes in sizes().
class any_mechanism {
 public:
  /// Conversion between encoder axes and joints (encoder_axes.hpp), column by column.
  struct encoder_maps {
    int count = 0;                                                           ///< Number of encoders.
    std::array<double, std::size_t(max_joints) * max_joints> from_joints{};  ///< T
    std::array<double, std::size_t(max_joints) * max_joints> to_joints{};    ///< T^+
  };

  /// joint_solution of any mechanism.
  struct joint_pose {
    joint_numbers q;              ///< n, as there.
    status outcome = status::ok;  ///< As there.
    bool has_inverse = false;     ///< False without an inverse formula.
  };

  virtual ~any_mechanism() = default;
  /// n, d and m.
  virtual device_sizes sizes() const noexcept = 0;
  /// True if it has mass_matrix, bias_torque and bias_acceleration.
  virtual bool has_inertia() const noexcept = 0;
  /// False if M::handle_rotates is false: the handle keeps its orientation.
  virtual bool handle_rotates() const noexcept = 0;
  /// End effector [m], base frame.
  virtual task_numbers position(std::span<const double> q) const noexcept = 0;
  /// J, d x n, column by column.
  virtual void jacobian(std::span<const double> q, std::span<double> J) const noexcept = 0;
  /// w = T qd [rad/s or m/s].
  virtual joint_numbers brake_rates(std::span<const double> q, std::span<const double> qd) const noexcept = 0;
  /// Joint positions for the end effector at x by the mechanism's formula; has_inverse is false without one.
  /// `branch` is only used by mechanisms that need it.
  virtual joint_pose solve(std::span<const double> x, elbow branch) const = 0;
  /// As solve(), in the usual branch; empty without a formula or if x is out of reach.
  joint_numbers inverse(std::span<const double> x) const {
    const joint_pose found = solve(x, elbow::left);
    return found.has_inverse && found.outcome == status::ok ? found.q : joint_numbers();
  }
  /// The maps of the encoders.
  virtual encoder_maps encoders() const noexcept = 0;

  /// Type and address of the held_mechanism that controllers and plants use.
  virtual std::pair<std::type_index, const void*> held() const noexcept = 0;
};

/// Holds a mechanism M.
template <DifferentiableMechanism M>
class mechanism_model final : public any_mechanism {
  static constexpr int n = M::dof, d = M::task_dimension, m = M::brake_count;
  static_assert(n <= max_joints && m <= max_joints, "passive_haptics: at most 8 joints and 8 brakes.");
  using held_type = held_mechanism<M>;

 public:
  /// Holds this mechanism.
  explicit mechanism_model(M mechanism) : own_(std::move(mechanism)), held_(own_) {}

  device_sizes sizes() const noexcept override { return {n, d, m}; }
  bool has_inertia() const noexcept override { return Dynamics<M>; }
  bool handle_rotates() const noexcept override {
    if constexpr (requires { M::handle_rotates; }) return M::handle_rotates;
    else return true;
  }
  task_numbers position(std::span<const double> q) const noexcept override {
    const joint_vector<M> at(q.data());
    return task_numbers(mechanism_pose<M>(own_, at).position());  // bit-identical to a cycle
  }
  void jacobian(std::span<const double> q, std::span<double> J) const noexcept override {
    const jacobian_matrix<M> found(passive_haptics::jacobian(own_, joint_vector<M>(q.data())));
    std::copy_n(found.data(), std::min<std::size_t>(J.size(), n * d), J.data());
  }
  joint_numbers brake_rates(std::span<const double> q, std::span<const double> qd) const noexcept override {
    return joint_numbers(
        passive_haptics::brake_rates(own_, joint_vector<M>(q.data()), joint_vector<M>(qd.data())));
  }
  joint_pose solve([[maybe_unused]] std::span<const double> x, [[maybe_unused]] elbow branch) const override {
    const auto found = [](const auto& solution) {
      return joint_pose{joint_numbers(solution.q), solution.outcome, true};
    };
    if constexpr (requires(const task_vector<M>& p) { own_.inverse(p).q; })
      return found(own_.inverse(task_vector<M>(x.data())));
    else if constexpr (requires(const task_vector<M>& p) { own_.inverse(p, elbow::left).q; })
      return found(own_.inverse(task_vector<M>(x.data()), branch));
    else return {};
  }
  encoder_maps encoders() const noexcept override {
    const encoder_axes<M> axes(own_);
    constexpr int count = encoder_axes<M>::count;
    encoder_maps maps;
    maps.count = count;
    for (int i = 0; i < n; ++i) {
      const auto column = axes.from_joints(joint_vector<M>::Unit(i));
      std::copy_n(column.data(), count, maps.from_joints.data() + i * count);
    }
    for (int i = 0; i < count; ++i) {
      const auto column = axes.to_joints(vector<double, count>::Unit(i));
      std::copy_n(column.data(), n, maps.to_joints.data() + i * n);
    }
    return maps;
  }
  std::pair<std::type_index, const void*> held() const noexcept override {
    return {typeid(held_type), &held_};
  }

 private:
  M own_;
  held_type held_;
};

}  // namespace passive_haptics::runtime
