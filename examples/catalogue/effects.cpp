#include <catalogue/entries.hpp>

#include <passive_haptics/force/effects/detents.hpp>
#include <passive_haptics/force/effects/end_stops.hpp>
#include <passive_haptics/force/effects/guide.hpp>
#include <passive_haptics/force/effects/rough_walls.hpp>
#include <passive_haptics/force/effects/viscous_field.hpp>

// The effects by name: one line for each.
void example::add_effects(passive_haptics::runtime::catalogue& all) {
  namespace ph = passive_haptics;
  using T = double;
  const auto add = [&]<int D>() {
    all.add_effect<D, ph::viscous_field<T, D>, ph::viscous_field_parameters<T, D>>("viscous_field");
    all.add_effect<D, ph::guide<T, D>, ph::guide_parameters<T, D>>("guide");
    all.add_effect<D, ph::detents<T, D>, ph::detents_parameters<T, D>>("detents");
    all.add_effect<D, ph::end_stops<T, D>, ph::end_stops_parameters<T, D>>("end_stops");
    all.add_effect<D, ph::rough_walls<T, D>, ph::wall_friction_parameters<T>>("rough_walls");
  };
  add.operator()<2>();
  add.operator()<3>();
}
