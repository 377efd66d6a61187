/// @file
/// The functions of a device of one mechanism.
#pragma once

#include <passive_haptics_python/any_device.hpp>
#include <passive_haptics_python/controller_of.hpp>
#include <passive_haptics_python/from_python.hpp>
#include <passive_haptics_python/simulation_of.hpp>

#include <passive_haptics/brake/passive_constraint.hpp>
#include <passive_haptics/brake/reference_forces.hpp>
#include <passive_haptics/control/pipelines/several_walls.hpp>
#include <passive_haptics/design/braked_wall_at.hpp>
#include <passive_haptics/design/fme_boundary.hpp>
#include <passive_haptics/design/sink_depth.hpp>
#include <passive_haptics/force/nearest_force.hpp>

#include <cmath>

namespace passive_haptics_python {

/// The functions of mechanism M, and its controllers under these laws.
template <class M, class Laws>
class device_of;

/// With these laws.
template <class M, class... Laws>
class device_of<M, law_list<Laws...>> final : public any_device {
  static constexpr int n = M::dof, d = M::task_dimension, m = M::brake_count;
  static constexpr bool has_reference_forces = n == d && m == n;

 public:
  /// has_inertia: false where the mechanism within M has none.
  device_of(M mechanism, bool has_inertia) : model_(std::move(mechanism)), has_inertia_(has_inertia) {}

  device_sizes sizes() const override { return {n, d, m}; }

  std::unique_ptr<any_controller> make_controller(const brake_numbers& brakes, const scene& walls,
                                                  const law& of, const ph::step_options<double>& options,
                                                  std::unique_ptr<any_batch> at_wall) const override {
    std::unique_ptr<any_controller> made;
    const auto try_law = [&]<class L>(std::type_identity<L>) {
      const auto* chosen = dynamic_cast<const law_value<L>*>(&of);
      if (made || chosen == nullptr) return;
      made = passive_haptics_python::make_controller<M, L>(model_, controller_brakes_from<M>(brakes), walls,
                                                           made_law<L>(chosen->table), options,
                                                           std::move(at_wall));
    };
    (try_law(std::type_identity<Laws>()), ...);
    return made;
  }

  numbers position(const numbers& q) const override {
    return ph::mechanism_pose<M>(model_, at(q)).position();
  }
  Eigen::MatrixXd jacobian(const numbers& q) const override {
    return ph::jacobian_matrix<M>(ph::jacobian(model_, at(q)));
  }
  numbers velocity(const numbers& q, const numbers& qd) const override {
    return ph::velocity(model_, at(q), joints(qd, "qd"));
  }
  numbers brake_rates(const numbers& q, const numbers& qd) const override {
    return ph::brake_rates(model_, at(q), joints(qd, "qd"));
  }
  numbers brake_signs(const numbers& q, const numbers& qd, const std::optional<numbers>& hand_force,
                      const brake_numbers& brakes) const override {
    const ph::joint_vector<M> here = at(q), rates = joints(qd, "qd");
    ph::task_vector<M> Fh = ph::task_vector<M>::Zero();
    if (hand_force) Fh = task(*hand_force, "hand_force");
    const auto E = ph::brake_jacobian(model_, here);
    const ph::brake_vector<M> th = ph::brake_torque(E, Fh);
    return ph::brake_signs(ph::brake_rates(model_, here, rates), th, brakes_from<M>(brakes));
  }

  reference_force_values reference_forces([[maybe_unused]] const numbers& q) const override {
    if constexpr (has_reference_forces) {
      const auto set = ph::reference_forces(model_, at(q));
      return {set.G, set.outcome};
    } else refuse("reference_forces", "as many brakes and joints as task dimensions");
  }
  numbers nearest_force([[maybe_unused]] const numbers& q, [[maybe_unused]] const numbers& signs,
                        [[maybe_unused]] const numbers& desired) const override {
    if constexpr (has_reference_forces) {
      const auto E = ph::brake_jacobian(model_, at(q));
      return ph::nearest_force(E, of_brakes(signs, "signs"), task(desired, "desired_force")).force;
    } else refuse("nearest_force", "as many brakes and joints as task dimensions");
  }
  std::vector<outlined_fme> passive_fmes([[maybe_unused]] const numbers& q,
                                         [[maybe_unused]] int segments) const override {
    if constexpr (has_reference_forces && n == 2) {
      const auto set = ph::reference_forces(model_, at(q));
      std::vector<outlined_fme> all;
      for (const auto& region : ph::passive_fme_regions<2>())
        all.push_back({{region[0], region[1]}, ph::passive_fme_outline<double>(set.G, region, segments)});
      return all;
    } else refuse("passive_fme", "two brakes on two joints in the plane");
  }

  displayable_values displayable(const path_values& place, const design_brakes& brakes) const override {
    const ph::path_point<M> p = point(place, "velocity");
    const auto found = ph::displayable(model_, p.q, p.direction, p.normal, switchable(brakes));
    return {found.outcome, found.display, found.angle, found.max_force, found.max_approximated_force,
            found.signs};
  }
  ph::sink_slope_result<double> sink_slope(const path_values& place, const design_brakes& brakes,
                                           double push) const override {
    const ph::path_point<M> p = point(place, "direction");
    return ph::sink_slope(model_, p.q, p.direction, p.normal, hybrid(brakes), push);
  }
  double sink_depth(const std::vector<path_values>& path, const design_brakes& brakes,
                    double push) const override {
    const auto size = double(path.size());
    const auto place = [&](double u) { return point(path[std::size_t(std::floor(u * size))], "direction"); };
    return ph::sink_depth(model_, place, hybrid(brakes), push, int(path.size()));
  }
  ph::design_figures<double> design_figures(const path_values& place, const design_brakes& brakes,
                                            double push) const override {
    return ph::design_figures_at(model_, point(place, "direction"), hybrid(brakes), push);
  }
  ph::braked_wall braked_wall_at([[maybe_unused]] const path_values& place,
                                 [[maybe_unused]] const design_brakes& brakes,
                                 [[maybe_unused]] const numbers& residual_torque,
                                 [[maybe_unused]] const numbers& resolution,
                                 [[maybe_unused]] double hand_mass) const override {
    require_inertia("braked_wall_at");
    if constexpr (ph::Dynamics<M>) {
      const ph::path_point<M> p = point(place, "velocity");
      return ph::braked_wall_at(model_, p.q, p.direction, p.normal, switchable(brakes),
                                of_brakes(residual_torque, "residual_torque"),
                                sized<ph::encoder_axes<M>::count>(resolution, "resolution", "encoders"),
                                hand_mass);
    } else refuse("braked_wall_at", "inertia");
  }

  std::unique_ptr<any_simulation> simulation([[maybe_unused]] const brake_numbers& brakes,
                                             [[maybe_unused]] double hand_mass,
                                             [[maybe_unused]] const numbers& q) const override {
    require_inertia("simulated_device");
    if (!brakes.has_no_bounds())
      refuse_value(
          "brakes of a simulated_device have a torque_lower or torque_upper, expected brakes that "
          "work both ways, or a list of brake models; a controller commands those that are off nothing");
    std::vector<run_time_brake> models;
    for (const auto& brake : ph::ideal_brakes(ph::require_valid(brakes_from<M>(brakes))))
      models.emplace_back(brake);
    return simulation(models, hand_mass, q);
  }
  std::unique_ptr<any_simulation> simulation([[maybe_unused]] const std::vector<run_time_brake>& brakes,
                                             [[maybe_unused]] double hand_mass,
                                             [[maybe_unused]] const numbers& q) const override {
    require_inertia("simulated_device");
    if constexpr (ph::Dynamics<M>)
      return std::make_unique<simulation_of<M>>(model_, models_for<M>(brakes), hand_mass, at(q));
    else refuse("simulated_device", "inertia");
  }

 private:
  static ph::joint_vector<M> at(const numbers& q) { return joints(q, "q"); }
  static ph::joint_vector<M> joints(const numbers& q, const char* name) {
    return sized<n>(q, name, "joints");
  }
  static ph::task_vector<M> task(const numbers& x, const char* name) {
    return sized<d>(x, name, "task dimensions");
  }
  static ph::brake_vector<M> of_brakes(const numbers& t, const char* name) {
    return sized<m>(t, name, "brakes");
  }
  static ph::path_point<M> point(const path_values& p, const char* direction) {
    return {at(p.q), task(p.direction, direction), task(p.normal, "normal")};
  }
  static ph::switchable_brakes<M> switchable(const design_brakes& b) {
    ph::switchable_brakes<M> of;
    of.torque_limit = b.torque_limit;
    of.time_constant = b.time_constant;
    of.torque_lower = b.torque_lower;
    of.torque_upper = b.torque_upper;
    return of;
  }
  static ph::hybrid_brakes<M> hybrid(const design_brakes& b) {
    return {switchable(b), of_brakes(b.motor_limit, "motor_limit")};
  }

  [[noreturn]] static void refuse(const char* function, const char* needs) {
    refuse_type(std::string(function) + " needs " + needs + ", but the mechanism has " + std::to_string(n) +
                " joints, " + std::to_string(m) + " brakes and " + std::to_string(d) +
                " task dimensions; take another mechanism");
  }
  void require_inertia(const char* function) const {
    if (!has_inertia_)
      refuse_type(std::string(function) +
                  " needs a mechanism with inertia; take one, such as planar_chain_3_with_inertia");
  }

  M model_;
  bool has_inertia_;
};

}  // namespace passive_haptics_python
