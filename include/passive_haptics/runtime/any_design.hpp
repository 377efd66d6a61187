/// Design functions (design/, force/) and the wall-following experiment for mechanisms chosen at run time.
#pragma once

#include <passive_haptics/brake/reference_forces.hpp>
#include <passive_haptics/control/cycle_inputs.hpp>
#include <passive_haptics/design/displayable.hpp>
#include <passive_haptics/design/map/design_figures.hpp>
#include <passive_haptics/design/sink_depth.hpp>
#include <passive_haptics/force/nearest_force.hpp>
#include <passive_haptics/plant/wall_following.hpp>
#include <passive_haptics/runtime/any_mechanism.hpp>
#include <passive_haptics/runtime/any_plant.hpp>
#include <passive_haptics/runtime/any_shape.hpp>
#include <passive_haptics/runtime/brake_numbers.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <typeindex>
#include <variant>
#include <vector>

namespace passive_haptics::runtime {

/// path_point of any device.
struct path_place {
  std::span<const double> q;          ///< n [rad or m]
  std::span<const double> direction;  ///< d, direction of motion, any length.
  std::span<const double> normal;     ///< d, outward normal of the wall.
};

/// hybrid_brakes of any device.
struct design_brakes {
  brake_numbers brakes;             ///< Limits may be infinite.
  std::vector<double> motor_limit;  ///< m [N m]
};

/// displayable_force of any device, with equal names.
struct displayable_record {
  status outcome = status::ok;                  ///< ok, or an error.
  display_class display = display_class::none;  ///< As there.
  double angle = 0;                             ///< [rad]
  double max_force = 0;                         ///< [N]
  double max_approximated_force = 0;            ///< [N]
  task_numbers nearest;                         ///< d [N]
  joint_numbers signs;                          ///< m
};

/// reference_force_set of any device: forces of unit brake torques.
struct reference_force_record {
  status outcome = status::ok;    ///< ok, or an error.
  std::array<double, 3 * 3> G{};  ///< d x m [N per N m], column by column.
};

/// wall_following_sample of any device.
struct following_record {
  double time = 0;                        ///< [s]
  double depth = 0;                       ///< [m]
  task_numbers position;                  ///< d [m]
  task_numbers velocity;                  ///< d [m/s]
  joint_numbers rates;                    ///< m [rad/s or m/s]
  joint_numbers brake_torque;             ///< m [N m]
  joint_numbers brake_power;              ///< m [W]
  task_numbers hand_force;                ///< d [N]
  task_numbers brake_force;               ///< d [N]
  const cycle_record* control = nullptr;  ///< The latest control cycle.
};

/// following_hand of any dimension.
struct hand_description {
  std::vector<double> direction;                 ///< d, any length > 0.
  std::vector<double> start;                     ///< d [m]
  following_hand_parameters<double> parameters;  ///< Impedance.

  /// The hand of D dimensions. Throws std::invalid_argument for wrong sizes or parameters.
  template <int D>
  following_hand<double, D> hand() const {
    require_count("components of the direction", std::ssize(direction), D);
    require_count("components of the start", std::ssize(start), D);
    return {vector<double, D>(direction.data()), vector<double, D>(start.data()), parameters};
  }
};

/// A planar or spatial shape.
using shape_variant = std::variant<any_shape<2>, any_shape<3>>;

/// Design functions of a device. All throw std::invalid_argument for wrong sizes or as the original
/// functions.
class any_design {
 public:
  virtual ~any_design() = default;
  /// True if reference_forces() and nearest_force() are defined: n = m = d.
  virtual bool has_reference_forces() const = 0;
  /// Signs of the brakes; an empty hand force [N] counts as zero.
  virtual joint_numbers brake_signs(std::span<const double> q, std::span<const double> qd,
                                    std::span<const double> hand_force,
                                    const brake_numbers& brakes) const = 0;
  /// See passive_haptics::reference_forces().
  virtual reference_force_record reference_forces(std::span<const double> q) const = 0;
  /// Nearest force to the desired one for brakes with these signs [N].
  virtual task_numbers nearest_force(std::span<const double> q, std::span<const double> signs,
                                     std::span<const double> desired) const = 0;
  /// See passive_haptics::displayable(); `direction` is the velocity.
  virtual displayable_record displayable(const path_place& at, const brake_numbers& brakes) const = 0;
  /// See passive_haptics::sink_slope(); push in N.
  virtual sink_slope_result<double> sink_slope(const path_place& at, const design_brakes& brakes,
                                               double push) const = 0;
  /// See passive_haptics::sink_depth(), for points at the middles of equal parts of the path.
  virtual double sink_depth(const std::vector<path_place>& path, const design_brakes& brakes,
                            double push) const = 0;
  /// See design_figures_at().
  virtual design_figures<double> figures(const path_place& at, const design_brakes& brakes,
                                         double push) const = 0;
  /// See passive_haptics::follow_wall(). The plant must be of make_plant(); `observe` may throw.
  virtual contact_metrics follow_wall(any_plant& plant,
                                      const std::function<cycle_record(const state_view&)>& control,
                                      const shape_variant& shape, const hand_description& hand,
                                      const wall_following_parameters& parameters,
                                      const std::function<void(const following_record&)>& observe) const = 0;
};

/// Compiled once per kind of mechanism.
template <class M>
class design_of final : public any_design {
  static constexpr int n = M::dof, d = M::task_dimension, m = M::brake_count;
  static constexpr bool has_references = n == d && m == n;

 public:
  /// Holds this mechanism.
  explicit design_of(M mechanism) : model_(std::move(mechanism)) {}

  bool has_reference_forces() const override { return has_references; }
  joint_numbers brake_signs(std::span<const double> q, std::span<const double> qd,
                            std::span<const double> hand_force, const brake_numbers& brakes) const override {
    const joint_vector<M> here = joints(q), rates = joints(qd);
    task_vector<M> Fh = task_vector<M>::Zero();
    if (!hand_force.empty()) Fh = task(hand_force);
    const brake_vector<M> th = brake_torque(brake_jacobian(model_, here), Fh);
    return joint_numbers(passive_haptics::brake_signs(passive_haptics::brake_rates(model_, here, rates), th,
                                                      of_device<brakes_of<M>>(brakes)));
  }
  reference_force_record reference_forces([[maybe_unused]] std::span<const double> q) const override {
    reference_force_record found;
    if constexpr (has_references) {
      const auto set = passive_haptics::reference_forces(model_, joints(q));
      found.outcome = set.outcome;
      std::copy_n(set.G.data(), d * m, found.G.data());
    }
    return found;
  }
  task_numbers nearest_force([[maybe_unused]] std::span<const double> q,
                             [[maybe_unused]] std::span<const double> signs,
                             [[maybe_unused]] std::span<const double> desired) const override {
    if constexpr (has_references) {
      require_count("signs", std::ssize(signs), m);
      const auto E = brake_jacobian(model_, joints(q));
      return task_numbers(
          passive_haptics::nearest_force(E, brake_vector<M>(signs.data()), task(desired)).force);
    }
    return {};
  }
  displayable_record displayable(const path_place& at, const brake_numbers& brakes) const override {
    const path_point<M> p = point(at);
    const auto found = passive_haptics::displayable(model_, p.q, p.direction, p.normal,
                                                    of_device<switchable_brakes<M>>(brakes));
    return {found.outcome,
            found.display,
            found.angle,
            found.max_force,
            found.max_approximated_force,
            task_numbers(found.nearest),
            joint_numbers(found.signs)};
  }
  sink_slope_result<double> sink_slope(const path_place& at, const design_brakes& brakes,
                                       double push) const override {
    const path_point<M> p = point(at);
    return passive_haptics::sink_slope(model_, p.q, p.direction, p.normal, hybrid(brakes), push);
  }
  double sink_depth(const std::vector<path_place>& path, const design_brakes& brakes,
                    double push) const override {
    const auto size = static_cast<double>(path.size());
    const auto place = [&](double u) { return point(path[static_cast<std::size_t>(std::floor(u * size))]); };
    return passive_haptics::sink_depth(model_, place, hybrid(brakes), push, static_cast<int>(path.size()));
  }
  design_figures<double> figures(const path_place& at, const design_brakes& brakes,
                                 double push) const override {
    return design_figures_at(model_, point(at), hybrid(brakes), push);
  }
  contact_metrics follow_wall([[maybe_unused]] any_plant& plant,
                              const std::function<cycle_record(const state_view&)>& control,
                              const shape_variant& shape, const hand_description& hand,
                              const wall_following_parameters& parameters,
                              const std::function<void(const following_record&)>& observe) const override {
    const auto* wall = std::get_if<any_shape<d>>(&shape);
    if (wall == nullptr)
      throw std::invalid_argument(
          "passive_haptics: dimension of the shape = " + std::to_string(d == 2 ? 3 : 2) + ": expected " +
          std::to_string(d) + ", that of the device");
    if constexpr (Dynamics<M>) {
      const auto decide = [&](const device_state<M>& s) {
        decision now{{}, control({s.time, span(s.q), span(s.qd), span(s.hand_force)})};
        now.capacity = brake_vector<M>(now.record.capacity.data());
        return now;
      };
      return passive_haptics::follow_wall(
          dynamic_cast<plant_of<M>&>(plant).device(), decide, *wall, hand.hand<d>(), parameters,
          [&](const auto& s) {
            observe({s.time, s.depth, task_numbers(s.position), task_numbers(s.velocity),
                     joint_numbers(s.rates), joint_numbers(s.brake_torque), joint_numbers(s.brake_power),
                     task_numbers(s.hand_force), task_numbers(s.brake_force), &s.control->record});
          });
    }
    return {};
  }

 private:
  struct decision {
    brake_vector<M> capacity = brake_vector<M>::Zero();
    cycle_record record;
  };

  template <class V>
  static std::span<const double> span(const V& v) {
    return {v.data(), static_cast<std::size_t>(v.size())};
  }
  static joint_vector<M> joints(std::span<const double> q) {
    require_count("joint positions or rates", std::ssize(q), n);
    return joint_vector<M>(q.data());
  }
  static task_vector<M> task(std::span<const double> x) {
    require_count("components of a vector of the task", std::ssize(x), d);
    return task_vector<M>(x.data());
  }
  static path_point<M> point(const path_place& at) {
    return {joints(at.q), task(at.direction), task(at.normal)};
  }
  template <class B>
  static B of_device(const brake_numbers& brakes) {
    require_count("brakes", std::ssize(brakes.torque_limit), m);
    return brakes.as<B>();
  }
  static hybrid_brakes<M> hybrid(const design_brakes& b) {
    require_count("motor limits", std::ssize(b.motor_limit), m);
    return {of_device<switchable_brakes<M>>(b.brakes), brake_vector<M>(b.motor_limit.data())};
  }

  M model_;
};

/// The compiled design functions, by kind of mechanism. Fill it before threads start.
class design_list {
 public:
  /// Compiles the functions for all mechanisms of M's kind.
  template <DifferentiableMechanism M>
  void compile_for() {
    using H = held_mechanism<M>;
    makers_[typeid(H)] = [](const void* of) -> std::unique_ptr<any_design> {
      return std::make_unique<design_of<H>>(*static_cast<const H*>(of));
    };
  }
  /// The functions of a mechanism; nullptr if its kind is not compiled.
  std::unique_ptr<any_design> make(const any_mechanism& mechanism) const {
    const auto [type, of] = mechanism.held();
    const auto found = makers_.find(type);
    return found == makers_.end() ? nullptr : found->second(of);
  }

 private:
  std::map<std::type_index, std::unique_ptr<any_design> (*)(const void*)> makers_;
};

}  // namespace passive_haptics::runtime
