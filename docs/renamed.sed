# Renames what a program takes from version 0.2.0 or from an unreleased one to the names of now:
#
#     sed -E -i -f docs/renamed.sed my_program.cpp
#
# Where a header stands
s#\bcontrol/extensions/rate_limited_brakes\.hpp#brake/models/rate_limited_brakes.hpp#g
s#\bbrake/measurement/encoder_axes\.hpp#brake/models/encoder_axes.hpp#g
s#\bbrake/models/any_brake\.hpp#plant/brakes/any_brake.hpp#g
s#\bbrake/models/compensated_brake\.hpp#plant/brakes/compensated_brake.hpp#g
s#\bbrake/models/coulomb_brake\.hpp#plant/brakes/coulomb_brake.hpp#g
s#\bbrake/models/delayed_brake\.hpp#plant/brakes/delayed_brake.hpp#g
s#\bbrake/models/eddy_current_brake\.hpp#plant/brakes/eddy_current_brake.hpp#g
s#\bbrake/models/magnetorheological_brake\.hpp#plant/brakes/magnetorheological_brake.hpp#g
s#\bbrake/models/stribeck_brake\.hpp#plant/brakes/stribeck_brake.hpp#g
s#\bbrake/models/first_order_lag\.hpp#core/scalar/first_order_lag.hpp#g
s#\bcore/unrolled\.hpp#core/flatten.hpp#g
s#\bcore/linear/orthogonalisation\.hpp#core/linear/orthogonal_decomposition.hpp#g
s#\bscene/mesh/proxy\.hpp#scene/proxy/proxy_way.hpp#g
s#\bscene/mesh/proxy_contacts\.hpp#scene/proxy/proxy_contacts.hpp#g
s#\bcontact_not_finite\b#contact_invalid#g
s#\bcontrol/effects/walls_and_effects\.hpp#control/ways/walls_and_effects.hpp#g
s#\bcontrol/effects/with_effects\.hpp#control/ways/with_effects.hpp#g
s#\bcontrol/laws/bang_bang_control\.hpp#control/laws/rivals/bang_bang_control.hpp#g
s#\bcontrol/laws/coercive_force_approximation\.hpp#control/laws/rivals/coercive_force_approximation.hpp#g
s#\bcontrol/laws/intended_rates\.hpp#control/laws/rivals/intended_rates.hpp#g
s#\bcontrol/laws/on_off_control\.hpp#control/laws/rivals/on_off_control.hpp#g
s#\bcontrol/laws/single_degree_of_freedom_control\.hpp#control/laws/rivals/single_degree_of_freedom_control.hpp#g
s#\bcontrol/laws/velocity_ratio_control\.hpp#control/laws/rivals/velocity_ratio_control.hpp#g
s#\bcontrol/laws/brake_lag\.hpp#control/laws/velocity/brake_lag.hpp#g
s#\bcontrol/laws/velocity_direct_control\.hpp#control/laws/velocity/velocity_direct_control.hpp#g
s#\bcontrol/laws/velocity_direct_control_parameters\.hpp#control/laws/velocity/velocity_direct_control_parameters.hpp#g
s#\bcontrol/normal_force/acceleration_display\.hpp#control/laws/velocity/acceleration_display.hpp#g
s#\bcontrol/normal_force/brake_reach\.hpp#control/laws/velocity/torque_range.hpp#g
s#\bcontrol/normal_force/least_power\.hpp#control/laws/velocity/least_power.hpp#g
s#\bcontrol/normal_force/braked_wall_at\.hpp#design/braked_wall_at.hpp#g
s#\bcontrol/normal_force/wall_limits\.hpp#design/wall_limits.hpp#g
s#\bcontrol/extensions/plausibility\.hpp#design/plausibility.hpp#g
s#\bbrake/drawing/fme_boundary\.hpp#design/fme_boundary.hpp#g
s#\bforce/display/displayable\.hpp#design/displayable.hpp#g
s#\bforce/display/undisplayable_share\.hpp#design/undisplayable_share.hpp#g
s#\bdriver/identification/bench_run\.hpp#bench/bench_run.hpp#g
s#\bdriver/identification/bench_sample\.hpp#bench/bench_sample.hpp#g
s#\bdriver/identification/current_ramp\.hpp#bench/current_ramp.hpp#g
s#\bdriver/identification/curve_fit\.hpp#bench/curve_fit.hpp#g
s#\bdriver/identification/magnetorheological_loop\.hpp#bench/magnetorheological_loop.hpp#g
s#\bdriver/identification/rate_sweep\.hpp#bench/rate_sweep.hpp#g
s#\bdriver/identification/step_response\.hpp#bench/step_response.hpp#g
s#\binterop/files/file_bytes\.hpp#scene/files/file_bytes.hpp#g
s#\binterop/files/file_kind\.hpp#scene/files/file_kind.hpp#g
s#\binterop/files/mesh_source\.hpp#scene/files/mesh_source.hpp#g
s#\binterop/files/obj\.hpp#scene/files/obj.hpp#g
s#\binterop/files/ply\.hpp#scene/files/ply.hpp#g
s#\binterop/files/ply_header\.hpp#scene/files/ply_header.hpp#g
s#\binterop/files/polygons\.hpp#scene/files/polygons.hpp#g
s#\binterop/files/stl\.hpp#scene/files/stl.hpp#g
s#\bcore/generators/column_subset\.hpp#core/linear/column_subset.hpp#g
s#\bcore/generators/generated_cone\.hpp#core/linear/generated_cone.hpp#g
s#\bcore/generators/least_distance\.hpp#core/linear/least_distance.hpp#g
s#\bcore/generators/least_norm\.hpp#core/linear/least_norm.hpp#g
s#\bcore/priorities/elimination\.hpp#core/linear/elimination.hpp#g
s#\bcore/priorities/least_squares_by_priority\.hpp#core/linear/least_squares_by_priority.hpp#g
s#\bcore/priorities/prioritised_least_squares\.hpp#core/linear/prioritised_least_squares.hpp#g
s#\bscene/shapes/room\.hpp#scene/shapes/walls_of.hpp#g
s#\bcontrol/account\.hpp#control/cycle_result.hpp#g
s#\bcontrol/stages\.hpp#control/cycle_inputs.hpp#g
s#\bcontrol/effects/effect_stages\.hpp#control/ways/beside_effects.hpp#g
s#\bcontrol/extensions/force_map\.hpp#force/torques/force_map.hpp#g
s#\bcontrol/extensions/generator_form\.hpp#control/ways/generator_form.hpp#g
s#\bcontrol/extensions/several_contacts\.hpp#control/ways/several_walls.hpp#g
s#\bcontrol/laws/torque_law\.hpp#control/ways/torque_law.hpp#g
s#\bcore/scalar/bit_cast\.hpp#core/arithmetic.hpp#g
s#\bmechanism/models/(joint_solution|two_link_inverse)\.hpp#mechanism/models/inverse_kinematics.hpp#g
# Types and functions
s/\bph::room\(/ph::walls_of(/g
s/\bph::alone\(/ph::as_single(/g
s/\bph::at_once\(/ph::releases_immediately(/g
s/\bph::in_doubt\(/ph::invalidates_position(/g
s/\bph::asks\(/ph::is_nonzero(/g
s/\bph::choose\(/ph::select(/g
s/\bph::pose\(/ph::mechanism_pose(/g
s/\bonly_contact\b/single_contact/g
s/\bbrake_reach</torque_range</g
# Members
s/\bheld_over\(\)/pending_fault()/g
s/\blarge_over\(/suspicious_above(/g
s/\bfor_each_large\b/for_each_suspicious/g
s/\bgives_way\b/nulls_normal_force/g
s/\bmost_overruns\b/max_overruns/g
s/\bmost_missed\b/max_missed/g
s/static constexpr bool inertial_forces = false/static constexpr auto self_motion = ph::self_motion_form::kinetostatic/g
s/static constexpr bool inertial_forces = true/static constexpr auto self_motion = ph::self_motion_form::inertial/g
s/const char\* owner\b/const char* type_name/g
# A contact's wall, its position and a report's first are words that other types have, too; the compiler finds them:
# contact::wall, contact_report::wall, step_result::wall -> wall_number, contact::position -> sensed_at,
# contact_report::first -> has_priority
# Requirements of a type
s#\bmechanism_requirements<([^<>]+)>::met#is_mechanism<\1, true>()#g
s#\bbrake_requirements<([^<>]+)>::met#are_brakes<\1, true>()#g
s#\bbrake_model_requirements<([^<>]+)>::met#is_brake_model<\1, true>()#g
s#\bport_requirements<([^<>]+)>::met#is_port<\1, true>()#g
s#\bsensor_requirements<([^<>]+)>::met#is_force_sensor<\1, true>()#g
s#\bself_motion_requirements<([^<>]+)>::met#has_known_forces<\1, true>()#g
