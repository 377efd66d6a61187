#include <catalogue/entries.hpp>

#include <passive_haptics/plant/brakes/coulomb_brake.hpp>
#include <passive_haptics/plant/brakes/eddy_current_brake.hpp>
#include <passive_haptics/plant/brakes/magnetorheological_brake.hpp>
#include <passive_haptics/plant/brakes/presliding_brake.hpp>
#include <passive_haptics/plant/brakes/stribeck_brake.hpp>

// The models of real brakes by name: one line for each.
void example::add_brake_models(passive_haptics::runtime::catalogue& all) {
  namespace ph = passive_haptics;
  all.add_brake_model<ph::coulomb_brake<double>>("coulomb");
  all.add_brake_model<ph::stribeck_brake<double>>("stribeck");
  all.add_brake_model<ph::magnetorheological_brake<double>>("magnetorheological");
  all.add_brake_model<ph::eddy_current_brake<double>>("eddy_current");
  all.add_brake_model<ph::presliding_brake<ph::coulomb_brake<double>>>("presliding");
}
