// Effects beside walls.
#include <precompiled.hpp>

#include "module.hpp"

#include <passive_haptics_python/effects.hpp>
#include <passive_haptics_python/values.hpp>

#include <passive_haptics/force/effects/detents.hpp>
#include <passive_haptics/force/effects/end_stops.hpp>
#include <passive_haptics/force/effects/guide.hpp>
#include <passive_haptics/force/effects/rough_walls.hpp>
#include <passive_haptics/force/effects/viscous_field.hpp>

#include <variant>

namespace passive_haptics_python {
namespace {

// An effect of the library behind virtual functions. Of the walls, if E is a WallEffect.
template <class E, int D>
struct effect_model final : any_effect<D> {
  using typename any_effect<D>::vector, typename any_effect<D>::contacts;
  explicit effect_model(E e) : of(std::move(e)) {}
  vector force(const vector& x, const vector& v, const vector& hand_force,
               const contacts& touched) const override {
    if constexpr (ph::Effect<E>) return of.force(x, v, hand_force);
    else return of.force_at(touched, v, hand_force);
  }
  E of;
};
template <class E, int N>
struct joint_effect_model final : any_joint_effect<N> {
  using typename any_joint_effect<N>::vector;
  explicit joint_effect_model(E e) : of(std::move(e)) {}
  vector torque(const vector& q, const vector& qd, const vector& hand_torque) const override {
    return of.torque(q, qd, hand_torque);
  }
  E of;
};

template <int D>
using viscous_field_table = ph::viscous_field_parameters<double, D>;
template <int D>
using guide_table = ph::guide_parameters<double, D>;
template <int D>
using detents_table = ph::detents_parameters<double, D>;
template <int N>
using end_stops_table = ph::end_stops_parameters<double, N>;
template <int D>
using viscous_field = ph::viscous_field<double, D>;
template <int D>
using guide = ph::guide<double, D>;
template <int D>
using detents = ph::detents<double, D>;
template <int N>
using end_stops = ph::end_stops<double, N>;

// An effect of vectors of 2 or 3 numbers. The first vector that is given says which.
template <template <int> class E, template <int> class P>
struct effect_of_vectors final : effect {
  std::variant<P<2>, P<3>> table;

  static std::vector<std::string> names() { return member_names<P<2>>(); }
  static effect_of_vectors made(const py::dict& given, const std::string& name) {
    return size_of(given, name) == 2 ? of_size<2>(given, name) : of_size<3>(given, name);
  }
  py::dict parameters() const {
    return std::visit([](const auto& p) { return to_dict(p); }, table);
  }
  // Those that are not the defaults; all if none of them is a vector, which says how many numbers there are.
  py::dict changed() const {
    return std::visit(
        [](const auto& p) {
          const py::dict changed = changed_members(p, std::decay_t<decltype(p)>{});
          for (const auto& [key, value] : changed)
            if (py::isinstance<py::list>(value)) return changed;
          return to_dict(p);
        },
        table);
  }

  std::shared_ptr<const any_effect<2>> as(kind<any_effect<2>>) const override { return on_handle<2>(); }
  std::shared_ptr<const any_effect<3>> as(kind<any_effect<3>>) const override { return on_handle<3>(); }
  std::shared_ptr<const any_joint_effect<2>> as(kind<any_joint_effect<2>>) const override {
    return on_joints<2>();
  }
  std::shared_ptr<const any_joint_effect<3>> as(kind<any_joint_effect<3>>) const override {
    return on_joints<3>();
  }

 private:
  template <int D>
  std::shared_ptr<const any_effect<D>> on_handle() const {
    if constexpr (ph::Effect<E<D>>)
      if (const auto* p = std::get_if<P<D>>(&table)) return std::make_shared<effect_model<E<D>, D>>(E<D>(*p));
    return nullptr;
  }
  template <int N>
  std::shared_ptr<const any_joint_effect<N>> on_joints() const {
    if constexpr (ph::JointEffect<E<N>>)
      if (const auto* p = std::get_if<P<N>>(&table))
        return std::make_shared<joint_effect_model<E<N>, N>>(E<N>(*p));
    return nullptr;
  }
  template <int D>
  static effect_of_vectors of_size(const py::dict& given, const std::string& name) {
    P<D> p{};
    assign_members(p, given, name);
    E<D> checked(p);
    effect_of_vectors made;
    made.table = p;
    return made;
  }
  static int size_of(const py::dict& given, const std::string& name) {
    if (const int found = first_length(given, name, "2 or 3")) return found;
    refuse_type(name + " needs a vector of 2 or 3 numbers among " + joined(names()));
  }
};

// Of whatever walls are touched, in the plane or in space.
struct rough_walls_value final : table_value<effect, ph::wall_friction_parameters<double>> {
  using table_type = ph::wall_friction_parameters<double>;
  rough_walls_value(const table_value& of) : table_value(of) {}
  static rough_walls_value made(const py::dict& given, const std::string& name) {
    return table_value::made(given, name);
  }
  std::shared_ptr<const any_effect<2>> as(kind<any_effect<2>>) const override { return on_handle<2>(); }
  std::shared_ptr<const any_effect<3>> as(kind<any_effect<3>>) const override { return on_handle<3>(); }

 private:
  template <int D>
  std::shared_ptr<const any_effect<D>> on_handle() const {
    using E = ph::rough_walls<double, D>;
    return std::make_shared<effect_model<E, D>>(E(table));
  }
};

template <class X, class P>
void bind_effect(py::module_& module, const std::string& name, const std::string& about) {
  const std::string text = "(" + stub_arguments<P>() + ")\n\n" + about + "\n\n" + parameter_lines<P>();
  py::class_<X, effect> bound(module, name.c_str(), text.c_str());
  add_value_protocol(bound, name);
}
template <template <int> class E, template <int> class P>
void bind_effect_of_vectors(py::module_& module, const std::string& name, const std::string& about) {
  bind_effect<effect_of_vectors<E, P>, P<2>>(module, name, about);
}

}  // namespace

void bind_effects(py::module_& module) {
  py::class_<effect>(module, "effect", "A force beside that of the walls, which resists motion.");
  const std::string sizes = " Of vectors of 2 numbers in the plane, of 3 in space.";
  bind_effect_of_vectors<viscous_field, viscous_field_table>(
      module, "viscous_field",
      "A resistance to all motion, F = -B v. viscosity: a d x d matrix; no motion may be driven by it." +
          sizes);
  bind_effect_of_vectors<guide, guide_table>(
      module, "guide",
      "A resistance to what leaves a line or a plane; motion along it and back is free." + sizes);
  bind_effect_of_vectors<detents, detents_table>(
      module, "detents", "Periodic positions along a direction that resist being left." + sizes);
  bind_effect<rough_walls_value, rough_walls_value::table_type>(
      module, "rough_walls",
      "Friction on all walls that are touched, under the load with which the hand presses.");
  bind_effect_of_vectors<end_stops, end_stops_table>(
      module, "end_stops",
      "Limits of the joints, which resist motion further out. Of vectors of as many numbers as there are "
      "joints, 2 or 3. For a sliding joint read N for N m and m for rad.");
}

}  // namespace passive_haptics_python
