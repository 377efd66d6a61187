// Test double of CHAI3D 3.3.0: the part of its class cGenericHapticDevice that interop/chai3d.hpp uses,
// written for these tests. It is not CHAI3D. With CHAI3D_ROOT the same tests run against CHAI3D itself.
#pragma once

#include <array>
#include <memory>

namespace chai3d {

struct cVector3d {
  cVector3d(double x = 0, double y = 0, double z = 0) : at{x, y, z} {}
  double operator()(int i) const { return at[static_cast<std::size_t>(i)]; }
  void set(const double& x, const double& y, const double& z) { at = {x, y, z}; }
  std::array<double, 3> at;
};

enum cHapticDeviceModel { C_HAPTIC_DEVICE_CUSTOM };

struct cHapticDeviceInfo {
  cHapticDeviceModel m_model;
  double m_maxLinearForce, m_maxLinearStiffness, m_workspaceRadius;
  bool m_sensedPosition, m_actuatedPosition;
};

class cGenericHapticDevice {
 public:
  virtual ~cGenericHapticDevice() = default;
  virtual bool open() = 0;
  virtual bool close() = 0;
  virtual bool calibrate(bool force = false) = 0;
  virtual bool getPosition(cVector3d& to) = 0;
  virtual bool getLinearVelocity(cVector3d& to) = 0;
  virtual bool enableForces(bool enabled) = 0;
  virtual bool setForceAndTorqueAndGripperForce(const cVector3d& force, const cVector3d& torque,
                                                double gripper_force) = 0;
  bool setForce(const cVector3d& force) { return setForceAndTorqueAndGripperForce(force, {}, 0); }
  cHapticDeviceInfo getSpecifications() { return m_specifications; }
  cHapticDeviceInfo m_specifications{};

 protected:
  cVector3d m_prevForce, m_prevTorque;
  double m_prevGripperForce = 0;
  bool m_deviceAvailable = false, m_deviceReady = false;
};
using cGenericHapticDevicePtr = std::shared_ptr<cGenericHapticDevice>;

}  // namespace chai3d
