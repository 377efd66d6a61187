/// @file
/// A device with brakes as a haptic device of CHAI3D 3.3 (https://www.chai3d.org, not in Debian).
#pragma once

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/parameters.hpp>

#include <devices/CGenericHapticDevice.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <limits>
#include <mutex>
#include <stop_token>
#include <thread>

namespace passive_haptics {

/// Parameters of a chai3d_device with D task dimensions.
template <int D>
struct chai3d_parameters {
  /// Stiffness of the scene's objects [N/m], in metres of the device. Required; the scene reads
  /// m_maxLinearStiffness.
  double stiffness = std::numeric_limits<double>::quiet_NaN();
  double max_force = 5;           ///< [N], read by the scene only; 5 N as in CHAI3D's template for devices.
  double workspace_radius = 0.1;  ///< [m], read by the scene only; 0.1 m is CHAI3D's default.
  point<D> centre = point<D>::Zero();  ///< Origin of CHAI3D [m], base frame.
  /// Axes of the base frame, as columns in the frame of CHAI3D, where x points towards the user, y to the
  /// right and z up. Default: a device on a desk with x to the right, y away from the user and z up.
  matrix<double, 3, D> axes = matrix<double, 3, 3>{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}.template leftCols<D>();
  double timeout = 0.02;  ///< Without a force for this time [s] the brakes are released; as a safe_port does.

  static constexpr const char* type_name = "a chai3d_device";  ///< In errors.
  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = chai3d_parameters;
    return member_table(member("stiffness", &p::stiffness, "N/m", range::positive),
                        member("max_force", &p::max_force, "N", range::positive),
                        member("workspace_radius", &p::workspace_radius, "m", range::positive),
                        member("centre", &p::centre, "m"), member("axes", &p::axes, "1"),
                        member("timeout", &p::timeout, "s", range::between(1e-3, 60)));
  }
  /// Rejects axes that are not unit vectors at right angles.
  error_message rules() const {
    const double error = (axes.transpose() * axes - matrix<double, D, D>::Identity()).norm();
    return error <= 1e-6
               ? error_message()
               : detail::error_text("|axes^T axes - 1|", error,
                                    "at most 1e-6: make the columns of axes unit vectors at right angles");
  }
};

/// The loop of a chai3d_device. measure() returns a device_state<M> or another state of M, and
/// after a failed measurement NaN, for example the default time. command() sets the maximum brake torques
/// [N m], each in [0, torque_limit].
template <class Loop, class M>
concept Chai3dLoop = requires(Loop& loop, const brake_vector<M>& capacity) {
  { loop.measure() } noexcept -> DeviceState<M>;
  { loop.command(capacity) } noexcept;
};

/// A haptic device of CHAI3D that displays the forces of a scene with brakes. Each force F becomes one
/// contact with normal F / |F| and depth |F| / stiffness, from which the law computes the capacities of the
/// brakes. Brakes only resist motion, so their power is never positive, whatever the scene demands.
///
/// Positions, velocities and forces are in m, m/s and N in the frame of CHAI3D (chai3d_parameters::axes). The
/// orientation is the identity. Forces outside the span of the axes, torques and gripper forces are ignored.
///
/// One thread, CHAI3D's haptic thread, makes the calls between open() and close(): getPosition(), which
/// measures, then getLinearVelocity() and setForce(). All capacities are 0
///   - before open(), after close() and after enableForces(false);
///   - if a force or state is NaN or infinite, or after any other fault of step();
///   - for a force without a getPosition() since the last one;
///   - if no force arrives for `timeout`: a thread of the device then commands 0. The next force is not
///     displayed, its outcome is status::scene_stale, and the law's memory is reset.
/// If the loop's own functions never return, or the program is stopped or crashes, only the hardware or a
/// supervisor can release the brakes.
///
/// Cost of a force: that of step(). No call of the haptic thread allocates, throws, locks or reads a clock.
template <class M, class B, class L, class Loop>
class chai3d_device final : public chai3d::cGenericHapticDevice {
  static_assert(Chai3dLoop<Loop, M>,
                "passive_haptics: the loop needs `device_state<M> measure() noexcept` and "
                "`void command(const brake_vector<M>& capacity) noexcept`.");
  static constexpr int D = M::task_dimension;
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

 public:
  using parameters = chai3d_parameters<D>;  ///< Parameters.

  /// Throws std::invalid_argument with the text of validate(p), or of controller's constructor.
  chai3d_device(M mechanism, const B& brakes, L law, Loop loop, const parameters& p)
      : p_(require_valid(p)),
        control_(std::move(mechanism), brakes, scene{.stiffness = p.stiffness}, std::move(law)),
        loop_(std::move(loop)) {
    m_deviceAvailable = true;
    m_specifications.m_model = chai3d::C_HAPTIC_DEVICE_CUSTOM;
    m_specifications.m_maxLinearForce = p.max_force;
    m_specifications.m_maxLinearStiffness = p.stiffness;
    m_specifications.m_workspaceRadius = p.workspace_radius;
    m_specifications.m_sensedPosition = m_specifications.m_actuatedPosition = true;
  }
  ~chai3d_device() override { close(); }

  /// Starts with all capacities 0; false if the device is open. Throws std::system_error without a thread.
  bool open() override {
    if (m_deviceReady) return false;
    control_.reset();
    measured_ = stalled_ = false;
    state_.time = unknown;
    command(brake_vector<M>::Zero());
    watch_ = std::jthread([this](std::stop_token end) { watch(end); });
    return m_deviceReady = true;
  }
  /// Sets all capacities to 0, also while the haptic thread still runs; false if the device is not open.
  bool close() override {
    if (!m_deviceReady) return false;
    watch_ = {};
    const std::scoped_lock mine(turn_);
    m_deviceReady = false;
    command(brake_vector<M>::Zero());
    return true;
  }
  /// Encoders are homed by the loop, before open().
  bool calibrate(bool = false) override { return m_deviceReady; }
  /// False: all capacities are 0 from the next force on. True: forces are displayed.
  bool enableForces(bool enabled) override {
    enabled_.store(enabled, std::memory_order_relaxed);
    return m_deviceReady;
  }

  /// Measures. If that fails, `to` is the last good position, and the result is false.
  bool getPosition(chai3d::cVector3d& to) override {
    if (const std::unique_lock mine(turn_, std::try_to_lock); mine && m_deviceReady) measure();
    to.set(position_[0], position_[1], position_[2]);
    return m_deviceReady && measured_;
  }
  /// J qd of the last getPosition(), not an average over CHAI3D's 15 ms.
  bool getLinearVelocity(chai3d::cVector3d& to) override {
    to.set(velocity_[0], velocity_[1], velocity_[2]);
    return m_deviceReady && measured_;
  }
  /// Displays a force of the scene; false, with all capacities 0, unless result().outcome is ok.
  bool setForceAndTorqueAndGripperForce(const chai3d::cVector3d& force, const chai3d::cVector3d& torque,
                                        double gripper_force) override {
    const std::unique_lock mine(turn_, std::try_to_lock);
    if (!mine || !m_deviceReady) return false;
    forces_.fetch_add(1, std::memory_order_relaxed);  // Before braking_, so that the watch sees both or none
    m_prevForce = force, m_prevTorque = torque, m_prevGripperForce = gripper_force;
    const bool shows = enabled_.load(std::memory_order_relaxed);  // NaN times 0 is NaN, whatever the axes
    control_.scene().force =
        shows ? point<D>(p_.axes.transpose() * point<3>(force(0), force(1), force(2))) : point<D>::Zero();
    if (std::exchange(stalled_, false)) {
      control_.reset();
      result_ = released<result_type>(status::scene_stale);
    } else {
      result_ = control_(state_);
    }
    state_.time = unknown;  // Until the next measurement
    command(result_.capacity);
    return result_.outcome == status::ok;
  }

  /// Result of the last force, for the haptic thread.
  const auto& result() const { return result_; }

 private:
  // The force of CHAI3D as what the handle touches.
  struct scene {
    using contacts_type = contacts<D, 1>;
    static constexpr int dimension = D;
    contacts_type touched_at(const point<D>& x) const {
      contacts_type touched;
      const double size = force.stableNorm();
      if (size != 0)
        touched.push_back(
            {.normal = force / size, .depth = size / stiffness, .stiffness = stiffness, .sensed_at = x});
      return touched;
    }
    double stiffness;                   // [N/m]
    point<D> force = point<D>::Zero();  // [N], base frame
  };
  using controller_type = controller<M, scene, L, B>;
  using result_type = typename controller_type::result_type;

  void measure() {
    state_ = loop_.measure();
    const mechanism_pose<M> pose(control_.mechanism(), state_.q);
    const point<3> x = p_.axes * (as<double>(pose.position()) - p_.centre);
    const point<3> v = p_.axes * as<double>(pose.velocity(state_.qd));
    measured_ = all_finite(state_.time, x, v);
    velocity_ = measured_ ? v : point<3>::Zero();
    if (measured_) position_ = x;
  }
  void command(const brake_vector<M>& capacity) {
    loop_.command(capacity);
    braking_.store((capacity.array() != 0).any(), std::memory_order_release);
  }
  // Looks twice in a timeout. No new force while the brakes are on is a stall; only then it takes the turn.
  void watch(const std::stop_token& end) {
    std::mutex sleeping;
    std::condition_variable_any wake;
    std::unique_lock lock(sleeping);
    const std::chrono::duration<double> pause(p_.timeout / 2);
    for (std::uint64_t seen = 0; !end.stop_requested();
         wake.wait_for(lock, end, pause, [] { return false; })) {
      const bool braking = braking_.load(std::memory_order_acquire);
      const std::uint64_t before = std::exchange(seen, forces_.load(std::memory_order_relaxed));
      if (!braking || seen != before) continue;
      const std::unique_lock mine(turn_, std::try_to_lock);
      if (!mine || forces_.load(std::memory_order_relaxed) != seen) continue;
      command(brake_vector<M>::Zero());
      stalled_ = true;
    }
  }

  parameters p_;
  controller_type control_;
  Loop loop_;
  decltype(std::declval<Loop&>().measure()) state_;
  result_type result_;
  point<3> position_ = point<3>::Zero(), velocity_ = point<3>::Zero();  // [m], [m/s], frame of CHAI3D
  bool measured_ = false, stalled_ = false;
  std::atomic<bool> enabled_ = true, braking_ = false;
  std::atomic<std::uint64_t> forces_ = 0;
  std::mutex turn_;  // Held by who calls the loop. Neither the haptic thread nor the watch waits for it
  std::jthread watch_;
};

}  // namespace passive_haptics
