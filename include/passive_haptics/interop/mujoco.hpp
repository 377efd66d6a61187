/// @file
/// A plant simulated by MuJoCo (https://mujoco.org, Debian: libmujoco-dev), and models of mechanisms for it.
#pragma once

#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/mechanism/adaptors/braked_joints.hpp>
#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/plant/moving_device.hpp>

#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstring>
#include <limits>
#include <locale>
#include <memory>
#include <sstream>
#include <string>
#include <utility>

namespace passive_haptics {
namespace detail {

/// A chain as MuJoCo takes it: rotor_inertia is an armature, which may be negative.
template <int N, int D>
struct mujoco_chain {
  serial_chain_parameters<double, N, D> geometry;
  serial_chain_inertia<double, N, D> inertia;
};

template <int N, int D>
mujoco_chain<N, D> mujoco_chain_of(const serial_chain_with_inertia<double, N, D>& arm) {
  return {arm.parameters(), arm.inertia()};
}

/// Two rods. Rotors on the brakes' axes add R = T^T diag(I) T to M. Its coupling R(0, 1) becomes an inertia
/// of link 2, which adds to all of M, and the rest armatures: MuJoCo 2 has none for a tendon.
template <class Arm>
  requires std::same_as<Arm, two_link<double>> || std::same_as<Arm, tendon_two_link<double>>
mujoco_chain<2, 2> mujoco_chain_of(const Arm& arm) {
  const two_link_parameters<double>& p = arm.parameters();
  mujoco_chain<2, 2> c;
  c.geometry = planar_arm<double, 2>({p.length_1, p.length_2});
  const vector<double, 2> base(0, 0), elbow(p.length_1, 0), rotors(p.rotor_inertia_1, p.rotor_inertia_2);
  const matrix<double, 2, 2> Tt = transposed_transmission(arm, base);
  const matrix<double, 2, 2> R = Tt * scaled_rows(rotors, matrix<double, 2, 2>(transposed(Tt)));
  c.inertia.links = {uniform_rod<double, 2>(p.mass_1, base, elbow),
                     uniform_rod<double, 2>(p.mass_2, elbow, c.geometry.handle)};
  c.inertia.links[1].about_centre(0, 0) += R(0, 1);
  c.inertia.rotor_inertia = {R(0, 0) - R(0, 1), R(1, 1) - R(0, 1)};
  c.inertia.handle_mass = p.handle_mass;
  return c;
}

/// Two slides without links: their masses are armatures.
inline mujoco_chain<2, 2> mujoco_chain_of(const xy_table<double>& table) {
  mujoco_chain<2, 2> c;
  c.geometry = {{prismatic_joint<double, 2>({1, 0}), prismatic_joint<double, 2>({0, 1})}, {0, 0}};
  c.inertia.rotor_inertia = table.mass_matrix({0, 0}).diagonal();
  c.inertia.handle_mass = 0;
  return c;
}

template <class M, int... Brakes>
auto mujoco_chain_of(const braked_joints<M, Brakes...>& mechanism)
    -> decltype(mujoco_chain_of(mechanism.mechanism())) {
  return mujoco_chain_of(mechanism.mechanism());
}

/// Three components of a point or direction.
template <int D>
std::string mujoco_vector(const vector<double, D>& x) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(17);
  text << x[0] << ' ' << x[1] << ' ' << (D == 3 ? x[D - 1] : 0);
  return text.str();
}

/// The moment about the normal, or all. Of a thin rod in space MuJoCo would reject the moment 0, so 1e-12 of
/// the trace is added to each.
template <int D>
std::string mujoco_inertia(const inertia_matrix<double, D>& I) {
  if constexpr (D == 2) return "diaginertia='" + mujoco_vector<3>(vector<double, 3>::Constant(I(0, 0)));
  else {
    const vector<double, 3> moments = I.diagonal().array() + (1e-13 + 1e-12 * I.trace());
    return "fullinertia='" + mujoco_vector<3>(moments) + ' ' + mujoco_vector<3>({I(0, 1), I(0, 2), I(1, 2)});
  }
}

struct mujoco_deleter {
  void operator()(mjModel* m) const { mj_deleteModel(m); }
  void operator()(mjData* d) const { mj_deleteData(d); }
};

/// The model of a text. Files = mjVFS, a template since older versions of MuJoCo have other functions for it.
template <class Files = mjVFS>
std::unique_ptr<mjModel, mujoco_deleter> mujoco_load(const std::string& text) {
  constexpr const char* name = "mechanism.xml";
  const auto files = std::make_unique<Files>();
  const int size = static_cast<int>(text.size());
  mj_defaultVFS(files.get());
  if constexpr (requires { mj_addBufferVFS(files.get(), name, text.data(), size); }) {
    mj_addBufferVFS(files.get(), name, text.data(), size);
  } else {
    mj_makeEmptyFileVFS(files.get(), name, size);
    std::memcpy(files->filedata[0], text.data(), text.size());
  }
  std::array<char, 500> error{};
  std::unique_ptr<mjModel, mujoco_deleter> model(
      mj_loadXML(name, files.get(), error.data(), static_cast<int>(error.size())));
  mj_deleteVFS(files.get());
  if (!model) require_no_error(std::string("MuJoCo rejects the model: ").append(error.data()));
  return model;
}

}  // namespace detail

/// The model of a mechanism for MuJoCo as text (MJCF), with a hand of hand_mass [kg] on its handle: joints
/// `joint_1` to `joint_n`, for each brake a fixed tendon `brake_1` to `brake_m` with friction loss, and a
/// body `handle`. M is a two_link, tendon_two_link, xy_table or serial_chain_with_inertia (in the plane or in
/// space) in double, or one of these with braked_joints.
template <class M>
std::string mujoco_model(const M& mechanism, double hand_mass) {
  static_assert(
      requires { detail::mujoco_chain_of(mechanism); },
      "passive_haptics: mujoco_model has no text for this mechanism; expected two_link, tendon_two_link, "
      "xy_table or serial_chain_with_inertia in double. Give mujoco_device a model of your own.");
  const auto chain = detail::mujoco_chain_of(mechanism);
  constexpr int D = M::task_dimension;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(17);
  text << "<mujoco>\n<compiler angle='radian' boundmass='1e-14' boundinertia='1e-14'/>\n<option gravity='"
       << detail::mujoco_vector<D>(chain.inertia.gravity)
       << "' solver='Newton' iterations='100' tolerance='1e-14'><flag "
          "contact='disable'/></option>\n<worldbody>\n";
  vector<double, D> before = vector<double, D>::Zero();
  for (int i = 0; i < M::dof; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const chain_joint<double, D>& joint = chain.geometry.joints[k];
    const link_inertia<double, D>& link = chain.inertia.links[k];
    const bool turns = joint.kind == joint_kind::revolute;
    const vector<double, D> point = turns ? joint.point : before;
    text << "<body pos='" << detail::mujoco_vector<D>(point - before) << "'><joint name='joint_" << i + 1
         << "' type='" << (turns ? "hinge" : "slide") << "' axis='"
         << (turns && D == 2 ? "0 0 1" : detail::mujoco_vector<D>(joint.axis)) << "' armature='"
         << chain.inertia.rotor_inertia[i] << "'/>\n<inertial pos='"
         << detail::mujoco_vector<D>(link.mass > 0 ? link.centre - point : vector<double, D>::Zero())
         << "' mass='" << link.mass << "' " << detail::mujoco_inertia<D>(link.about_centre) << "'/>\n";
    before = point;
  }
  text << "<body name='handle' pos='" << detail::mujoco_vector<D>(chain.geometry.handle - before)
       << "'><inertial pos='0 0 0' mass='" << chain.inertia.handle_mass + hand_mass
       << "' diaginertia='1e-14 1e-14 1e-14'/></body>\n";
  for (int i = 0; i < M::dof; ++i) text << "</body>";
  text << "\n</worldbody>\n<tendon>\n";
  const matrix<double, M::dof, M::brake_count> Tt =
      transposed_transmission(mechanism, joint_vector<M>::Zero());
  for (int i = 0; i < M::brake_count; ++i) {
    text << "<fixed name='brake_" << i + 1 << "' frictionloss='1'>";
    for (int j = 0; j < M::dof; ++j)
      if (Tt(j, i) != 0) text << "<joint joint='joint_" << j + 1 << "' coef='" << Tt(j, i) << "'/>";
    text << "</fixed>\n";
  }
  text << "</tendon>\n</mujoco>\n";
  return text.str();
}

/// A Plant in MuJoCo with the constructors of simulated_device: brakes are friction losses of tendons, set in
/// each step to what their models resist with. Their drag is explicit; a compliance is an error.
///
/// Friction of MuJoCo is a soft constraint. In each step with w [rad/s] before and w' after it
///
///     w' = w + dt a,   a = -b w - R t  of a brake that does not slip,   R = s A,   b dt = 1 + s,
///
/// with s = (1 - d) / d of solimp d = 0.9999, b of solref = 2 dt, and A the inverse inertia of its axis in
/// the zero pose (tendon_invweight0). So w' = -s (w + dt A t), with two consequences:
///
///   - a brake that holds the torque t creeps at s dt A |t| (creep_rates);
///   - a brake may return energy, at most t w' <= s |t w| in a step. A brake that slips returns no more,
///   since
///     t then pushes away from the rate at which it would stick.
///
/// A step that is not finite gives joint rates of NaN. No allocation in a step.
template <class M, class Model = coulomb_brake<double>>
class mujoco_device : public moving_device<M, Model> {
  using base = moving_device<M, Model>;
  static_assert(std::same_as<typename M::scalar, double>, "passive_haptics: a mujoco_device needs double.");

 public:
  /// At rest at q, with brakes that are what their controller believes. Throws std::invalid_argument as
  /// simulated_device does, or with MuJoCo's text.
  mujoco_device(M mechanism, const brakes_of<M>& brakes, double hand_mass, const joint_vector<M>& q)
    requires std::same_as<Model, coulomb_brake<double>>
      : mujoco_device(std::move(mechanism), ideal_brakes(require_valid(brakes)), hand_mass, q) {}

  /// A device with real brakes, about which a controller may be wrong.
  template <std::same_as<brake_models_of<M, Model>> RealBrakes>
  mujoco_device(M mechanism, const RealBrakes& brakes, double hand_mass, const joint_vector<M>& q)
      : mujoco_device(mechanism, brakes, hand_mass, q, mujoco_model(mechanism, hand_mass)) {}

  /// A device with your own model (MJCF), which describes the mechanism and has the names of mujoco_model().
  template <std::same_as<brake_models_of<M, Model>> RealBrakes>
  mujoco_device(M mechanism, const RealBrakes& brakes, double hand_mass, const joint_vector<M>& q,
                const std::string& model)
      : base(std::move(mechanism), brakes, hand_mass, q),
        model_(detail::mujoco_load(model)),
        data_(mj_makeData(model_.get())),
        handle_(find(mjOBJ_BODY, "handle")) {
    detail::refuse_unless(model_->nv == M::dof, "degrees of freedom of the MuJoCo model", model_->nv,
                          std::to_string(M::dof) + " as the mechanism has");
    for (int i = 0; i < M::dof; ++i) joint_[i] = model_->jnt_dofadr[find(mjOBJ_JOINT, "joint_", i + 1)];
    for (int i = 0; i < M::brake_count; ++i) {
      brake_[i] = find(mjOBJ_TENDON, "brake_", i + 1);
      mjtNum* const solimp = model_->tendon_solimp_fri + mjNIMP * brake_[i];
      solimp[0] = solimp[1] = impedance;
    }
    const double twist = this->compliance().cwiseAbs().maxCoeff();
    detail::refuse_unless(twist == 0, "compliance [rad/(N m)]", twist, "0 in MuJoCo; use a simulated_device");
    gravity_of_hand_ = hand_mass * Eigen::Map<const task_vector<M>>(model_->opt.gravity);
  }

  using base::set_motion;

  /// One time step dt [s], as of a simulated_device.
  void advance(double dt, const brake_vector<M>& capacity, const task_vector<M>& muscle_force) {
    if (valid_time_step(dt) == 0) return;
    const auto now = this->begin_step(dt, capacity, muscle_force);
    if (!is_usable(this->q()) || !is_usable(this->qd()) || !is_usable(muscle_force)) {
      this->end_step(now, brake_vector<M>::Zero(),
                     joint_vector<M>::Constant(std::numeric_limits<double>::quiet_NaN()));
      return;
    }
    mjModel& m = *model_;
    mjData& d = *data_;
    m.opt.timestep = dt;
    for (int i = 0; i < M::brake_count; ++i) {
      m.tendon_frictionloss[brake_[i]] = std::min<double>(now.limit[i], mjMAXVAL);
      m.tendon_damping[brake_[i]] = now.commanded_drag[i] + now.residual_drag[i];
      m.tendon_solref_fri[mjNREF * brake_[i]] = 2 * dt;
    }
    for (int i = 0; i < M::dof; ++i) {
      d.qpos[joint_[i]] = this->q()[i];  // of joints with one number each, in qpos where it is in qvel
      d.qvel[joint_[i]] = this->qd()[i];
    }
    // MuJoCo's gravity acts on the hand's mass, but the hand carries its own weight
    Eigen::Map<task_vector<M>>(d.xfrc_applied + 6 * handle_) = muscle_force - gravity_of_hand_;
    mj_forward(&m, &d);
    mj_Euler(&m, &d);  // the two are mj_step without its reset of a motion that is not finite
    brake_vector<M> torque = brake_vector<M>::Zero();
    for (int row = 0; row < d.nefc; ++row)
      if (d.efc_type[row] == mjCNSTR_FRICTION_TENDON)
        for (int i = 0; i < M::brake_count; ++i)
          if (d.efc_id[row] == brake_[i]) torque[i] = d.efc_force[row];
    joint_vector<M> next;
    for (int i = 0; i < M::dof; ++i) next[i] = d.qvel[joint_[i]];
    this->end_step(now, dt * torque, next);
  }

  /// Rate at which the axis of each brake creeps for each N m that it holds, in time steps of dt [s] [rad/s].
  brake_vector<M> creep_rates(double dt) const {
    brake_vector<M> rates;
    for (int i = 0; i < M::brake_count; ++i) rates[i] = softness * dt * model_->tendon_invweight0[brake_[i]];
    return rates;
  }
  /// d, the maximum that MuJoCo allows [1].
  static constexpr double impedance = 0.9999;
  /// s = (1 - d) / d: the most that a brake returns of the power |t w| with which a step begins [1].
  static constexpr double softness = (1 - impedance) / impedance;

  /// MuJoCo's own.
  const mjModel& model() const { return *model_; }
  /// MuJoCo's data: before the last step, except qpos and qvel.
  const mjData& data() const { return *data_; }

 private:
  // MuJoCo ends the program for what is not finite; mjMAXVAL is its own limit.
  static bool is_usable(const auto& x) { return all_finite(x) && x.cwiseAbs().maxCoeff() < mjMAXVAL; }

  int find(mjtObj kind, const std::string& prefix, int number = 0) const {
    const std::string name = number > 0 ? prefix + std::to_string(number) : prefix;
    const int id = mj_name2id(model_.get(), kind, name.c_str());
    if (id < 0) require_no_error("the MuJoCo model has no '" + name + "'; mujoco_model() lists the names");
    return id;
  }

  std::unique_ptr<mjModel, detail::mujoco_deleter> model_;
  std::unique_ptr<mjData, detail::mujoco_deleter> data_;
  int handle_;
  vector<int, M::dof> joint_;          // in qvel
  vector<int, M::brake_count> brake_;  // tendons
  task_vector<M> gravity_of_hand_;
};

/// Deduces Model from an array with one model for each brake.
template <class M, class Model, std::size_t Brakes>
mujoco_device(M, const std::array<Model, Brakes>&, double, const joint_vector<M>&) -> mujoco_device<M, Model>;

}  // namespace passive_haptics
