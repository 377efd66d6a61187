/// @file
/// The functions of kind.hpp for mechanisms of one kind; the sources kinds_*.cpp compile them.
#pragma once

#include "kind.hpp"

#include <catalogue/laws.hpp>

#include <passive_haptics/brake/at_rest/settled_rates.hpp>
#include <passive_haptics/brake/force_generators.hpp>
#include <passive_haptics/brake/signs.hpp>
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/design/displayable.hpp>
#include <passive_haptics/mechanism/dynamically_consistent_inverse.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace explorer {

/// Mechanisms of the kind of H (runtime::held_mechanism).
template <class H>
class kind_with final : public device_kind {
  static constexpr int n = H::dof, d = H::task_dimension, m = H::brake_count;
  using joints = ph::joint_vector<H>;
  using task = ph::task_vector<H>;
  using torques = ph::brake_vector<H>;

 public:
  /// Holds this mechanism.
  explicit kind_with(H mechanism) : model_(std::move(mechanism)) {}

  pose_brakes brakes_at(numbers q, numbers qd, const place& Fh, const brake_numbers& brakes) const override {
    const joints at(q.data()), rates(qd.data());
    const ph::mechanism_pose<H> pose(model_, at);
    const ph::brake_matrix<H> E(ph::brake_jacobian(model_, at));
    const torques w = ph::brake_rates(model_, at, rates);
    pose_brakes found;
    found.rates = joint_numbers(w);
    const torques of_hand = ph::brake_torque(E, in_task(Fh));
    found.signs = joint_numbers(ph::brake_signs(w, of_hand, brakes.as<ph::brakes_of<H>>()));
    for (int i = 0; i < m; ++i) found.E[std::size_t(i)] = in_space(ph::column(E, i));
    if constexpr (n == d) {
      const ph::brake_matrix<H> G = ph::force_generators(pose);
      found.has_forces = G.allFinite();
      for (int i = 0; found.has_forces && i < m; ++i)
        found.force[std::size_t(i)] = in_space(ph::column(G, i));
    }
    return found;
  }

  joint_numbers rates_for(numbers q, const place& v) const override {
    const ph::jacobian_matrix<H> J(ph::jacobian(model_, joints(q.data())));
    return J.allFinite() ? joint_numbers(joints(ph::pseudo_inverse(J) * in_task(v))) : joint_numbers();
  }

  place force_of(numbers q, numbers torque) const override {
    const joints at(q.data());
    const ph::mechanism_pose<H> pose(model_, at);
    const torques t(torque.data());
    task F;
    if constexpr (n == d) {
      F = ph::force_generators(pose) * t;
    } else {
      const ph::dynamically_consistent_inverse<double, n, d> inverse(ph::jacobian_matrix<H>(pose.jacobian()),
                                                                     pose.mass_matrix());
      F = inverse.forces(joints(pose.transposed_transmission() * t));
    }
    return F.allFinite() ? in_space(F) : place(place::Zero());
  }

  place settled_force(numbers q, numbers qd, numbers torque, const brake_numbers& brakes) const override {
    if constexpr (!ph::Settles<H>) {
      return force_of(q, torque);
    } else {
      const joints at(q.data());
      const ph::mechanism_pose<H> pose(model_, at);
      const torques size(torque.data());
      const ph::settled_rates<H> rates(
          pose, ph::settled_rates<H>::default_share,
          ph::brakes_without_torque<double, m>(brakes.as<ph::switchable_brakes<H>>()));
      task F = task::Zero();
      double least = std::numeric_limits<double>::infinity();
      rates.for_each([&](ph::brake_set, const auto& W) {
        const torques w = W * pose.velocity(joints(qd.data()));
        const double power = w.cwiseAbs().dot(size.cwiseAbs());
        if (!(power < least)) return false;
        least = power;
        torques t = size;
        for (int i = 0; i < m; ++i)
          if (w[i] != 0) t[i] = -std::copysign(t[i], w[i]);
        F = ph::transposed(W) * t;
        return false;
      });
      return in_space(F);
    }
  }

  displayed_at_most displayable(numbers q, const place& v, const place& normal,
                                const brake_numbers& brakes) const override {
    const auto found = ph::displayable(model_, joints(q.data()), in_task(v), in_task(normal), hybrid(brakes));
    if (found.outcome != ph::status::ok) return {};
    return {true, found.display, found.angle, found.max_force, found.max_approximated_force};
  }

  page_controller controller(const std::string& law, const runtime::any_parameters& parameters,
                             const brake_numbers& brakes, const scene_source& scene,
                             const ph::step_options<double>& options) const override {
    page_controller made;
    const auto add = [&]<class L>(const runtime::named_law<L>& one) {
      if (law == one.name)
        made =
            under(runtime::made_law<L>(parameters.as<runtime::law_parameters<L>>()), brakes, scene, options);
    };
    std::apply([&](const auto&... one) { (add(one), ...); }, example::laws);
    add(runtime::named_law<constant_scale>{"constant_scale"});
    return made;
  }

  std::unique_ptr<runtime::any_plant> plant(const std::vector<runtime::run_time_brake>& brakes,
                                            double hand_mass, numbers q) const override {
    return std::make_unique<runtime::plant_of<H>>(model_, brakes, hand_mass, q);
  }

 private:
  template <class L>
  page_controller under(const L& law, const brake_numbers& brakes, const scene_source& scene,
                        const ph::step_options<double>& options) const {
    using brakes_type = ph::switchable_brakes<H>;
    ph::controller<H, page_scene<d>, L, brakes_type> control(model_, brakes.as<brakes_type>(),
                                                             scene.make<d>(), law, options);
    return {[control](const runtime::state_view& s) mutable {
              const ph::device_state<H> state{s.time, joints(s.q.data()), joints(s.qd.data()),
                                              task(s.hand_force.data())};
              return runtime::cycle_record(control(state));
            },
            ph::TorqueLaw<L>};
  }

  static task in_task(const place& x) { return x.template head<d>(); }
  static place in_space(const task& x) { return place_of(runtime::task_numbers(x)); }
  static ph::hybrid_brakes<H> hybrid(const brake_numbers& brakes) {
    return ph::hybrid_brakes<H>(brakes.as<ph::switchable_brakes<H>>());
  }

  H model_;
};

/// The functions of this mechanism if it is of the kind of M, else nullptr.
template <class M>
std::unique_ptr<device_kind> kind_if(const runtime::any_mechanism& mechanism) {
  using H = runtime::held_mechanism<M>;
  const auto [type, of] = mechanism.held();
  if (type != typeid(H)) return nullptr;
  return std::make_unique<kind_with<H>>(*static_cast<const H*>(of));
}

}  // namespace explorer
