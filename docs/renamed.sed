# Renames what a program takes from version 0.2.0 or from an unreleased one to the names of now:
#
#     sed -E -i -f docs/renamed.sed my_program.cpp
#
# The same file serves programs in Python and configurations of brake_driver.
#
# Headers
s#\bbrake/drawing/fme_boundary\.hpp#design/fme_boundary.hpp#g
s#\bbrake/measurement/encoder_axes\.hpp#brake/models/encoder_axes.hpp#g
s#\bbrake/models/(any|compensated|coulomb|delayed|eddy_current|magnetorheological|stribeck)_brake\.hpp#plant/brakes/\1_brake.hpp#g
s#\bbrake/models/first_order_lag\.hpp#core/scalar/first_order_lag.hpp#g
s#\bcontrol/account\.hpp#control/cycle_result.hpp#g
s#\bcontrol/stages\.hpp#control/cycle_inputs.hpp#g
s#\bcontrol/effects/effect_stages\.hpp#control/pipelines/beside_effects.hpp#g
s#\bcontrol/effects/(walls_and_effects|with_effects)\.hpp#control/pipelines/\1.hpp#g
s#\bcontrol/extensions/several_contacts\.hpp#control/pipelines/several_walls.hpp#g
s#\bcontrol/laws/torque_law\.hpp#control/pipelines/torque_law.hpp#g
s#\bcontrol/extensions/(force_map|generator_form)\.hpp#force/forms/form_of.hpp#g
s#\bforce/torques/(force_map|generator_form)\.hpp#force/forms/form_of.hpp#g
s#\bcontrol/ways/(free_joints|generator|settled)_form\.hpp#force/forms/form_of.hpp#g
s#\bcontrol/ways/#control/pipelines/#g
s#\bcontrol/way\.hpp#control/pipeline.hpp#g
s#\bcontrol/extensions/rate_limited_brakes\.hpp#brake/models/rate_limited_brakes.hpp#g
s#\bcontrol/extensions/plausibility\.hpp#design/plausibility.hpp#g
s#\bcontrol/laws/rivals/(on_off_control|touch_margin)\.hpp#control/laws/\1.hpp#g
s#\bcontrol/laws/(brake_lag|velocity_direct_control|velocity_direct_control_parameters)\.hpp#control/laws/velocity/\1.hpp#g
s#\bcontrol/normal_force/acceleration_display\.hpp#control/laws/velocity/acceleration_display.hpp#g
s#\bcontrol/normal_force/brake_reach\.hpp#control/laws/velocity/torque_range.hpp#g
s#\bcontrol/(normal_force|laws/velocity)/least_power\.hpp#control/laws/velocity/min_power.hpp#g
s#\bcontrol/normal_force/(braked_wall_at|wall_limits)\.hpp#design/\1.hpp#g
s#\bcore/generators/(column_subset|generated_cone|least_distance|least_norm)\.hpp#core/linear/\1.hpp#g
s#\bcore/priorities/(elimination|least_squares_by_priority|prioritised_least_squares)\.hpp#core/linear/\1.hpp#g
s#\bcore/linear/orthogonalisation\.hpp#core/linear/orthogonal_decomposition.hpp#g
s#\bcore/linear/sine_cosine\.hpp#core/scalar/sine_cosine.hpp#g
s#\bcore/difference_of_products\.hpp#core/scalar/difference_of_products.hpp#g
s#\bcore/scalar/bit_cast\.hpp#core/arithmetic.hpp#g
s#\bcore/unrolled\.hpp#core/flatten.hpp#g
s#\bdesign/largest_resistance\.hpp#design/max_resistance.hpp#g
s#\bdesign/least_motor_share\.hpp#design/min_motor_share.hpp#g
s#\bdriver/identification/#bench/#g
s#\bforce/display/(displayable|undisplayable_share)\.hpp#design/\1.hpp#g
s#\binterop/files/#scene/files/#g
s#\bmechanism/models/(joint_solution|two_link_inverse)\.hpp#mechanism/models/inverse_kinematics.hpp#g
s#\bscene/mesh/proxy_contacts\.hpp#scene/proxy/proxy_contacts.hpp#g
s#\bscene/(mesh/proxy|proxy/proxy_way)\.hpp#scene/proxy/proxy_path.hpp#g
s#\bscene/shapes/room\.hpp#scene/shapes/walls_of.hpp#g
# Types and functions
s/\bph::alone\(/ph::as_single(/g
s/\bph::asks\(/ph::is_nonzero(/g
s/\bph::at_once\(/ph::releases_immediately(/g
s/\bph::choose\(/ph::select(/g
s/\bph::force_of\b/ph::desired_force_of/g
s/\bph::in_doubt\(/ph::invalidates_position(/g
s/\bph::pose\(/ph::mechanism_pose(/g
s/\bph::room\(/ph::walls_of(/g
s/\b(const )?ph::scene ([a-z_]+)\(/const auto \2 = ph::scene(/g
s/\b(const )?ph::scene ([a-z_]+)\{(.*)\};/const auto \2 = ph::scene(\3);/g
s/\bbest_cosine\b/max_cosine/g
s/\bbrake_reach</torque_range</g
s/\bcontact_not_finite\b/contact_invalid/g
s/\bfastest_time_constant\b/min_time_constant/g
s/\bfor_each_large\b/for_each_suspicious/g
s/\bleast_motor_share\b/min_motor_share/g
s/\bleast_sink_slope\b/min_sink_slope/g
s/\bonly_contact\b/single_contact/g
s/\bproxy_way\b/proxy_path/g
s/\bway_of</pipeline_of</g
s/\bworst_release_time\b/max_release_time/g
# Members
s/\bdepth_max\b/max_depth/g
s/\bdeepest_rest\b/max_rest_depth/g
s/\bfastest_rise\b/max_rise_rate/g
s/\bgives_way\b/nulls_normal_force/g
s/\b(greatest|largest)_current\b/max_current/g
s/\bheld_over\(\)/pending_fault()/g
s/\bhighest_temperature\b/max_temperature/g
s/\blarge_over\(/suspicious_above(/g
s/\blargest_(brake_power|rate|reading|start_depth)\b/max_\1/g
s/\bleast_cosine\b/min_cosine/g
s/\bleast_slenderness\b/min_slenderness/g
s/\blongest_(bench_overtime|gap|period|sample_period|sleep|time_constant)\b/max_\1/g
s/\blongest_look\b/max_look_time/g
s/\bmost_(contacts|missed|overruns)\b/max_\1/g
s/\bstrongest_nearest\b/max_approximated_force/g
s/\bconst char\* owner\b/const char* type_name/g
s/\.strongest\b/.max_force/g
s/\.let_go\(/.release_immediately(/g
s/\.largest\(\)/.maximum()/g
s/\bcurrents\.largest\b/currents.max_current/g
s/\bcurrents = \{\.largest\b/currents = {.max_current/g
s/\bat_release\.longest\(\)/at_release.max_duration()/g
# of wall_following_parameters
s/\.longest( = |\b)/.max_duration\1/g
s/\.deepest( = |\b)/.max_depth\1/g
s/\bwall_following_parameters\(longest=/wall_following_parameters(max_duration=/g
# of the tendon device
s/\.arm\.(length_1|length_2|mass_1|mass_2|handle_mass|rotor_inertia_1|rotor_inertia_2)\b/.\1/g
s/\{\.arm = \{([^{}]*)\}/{\1/g
# Requirements of a type
s#\bmechanism_requirements<([^<>]+)>::met#is_mechanism<\1, true>()#g
s#\bbrake_requirements<([^<>]+)>::met#are_brakes<\1, true>()#g
s#\bbrake_model_requirements<([^<>]+)>::met#is_brake_model<\1, true>()#g
s#\bport_requirements<([^<>]+)>::met#is_port<\1, true>()#g
s#\bsensor_requirements<([^<>]+)>::met#is_force_sensor<\1, true>()#g
# The package for Python. Parameters within parameters are gone: coulomb_brake(residual={"strength": 1}) is
# coulomb_brake(strength=1), stribeck_brake(coulomb={"gain": 2}) is stribeck_brake(gain=2), and a chain with
# inertia is serial_chain(joints=..., handle=..., links=...)
s#\bpassive_haptics_python/bind_mechanism\.hpp#passive_haptics_python/add_mechanism.hpp#g
s/\bbind_mechanism</add_mechanism</g
s/\b(ph|passive_haptics)\.brakes_[0-9]+\b/\1.brakes/g
s/\b(ph|passive_haptics)\.brake_parameters\b/\1.brakes/g
s/\bsweep\(([^()]*), seeds=/sweep(\1, items=/g
s/\b(ph|passive_haptics)\.(planar|spatial)_chain_[0-9](_with_inertia)?\b/\1.serial_chain/g
# Configurations of brake_driver; point of a plane is surface_point, as its error says
s/^law( *= *")/law.type\1/
s/^\[\[wall\]\]/[[walls]]/
s/^type( *= *)"plane"/type\1"half_space"/
s/^filling( *=)/inside\1/
# Some names are words that other types have, too. The compiler finds them:
# - contact::wall, contact_report::wall, step_result::wall -> wall_number; contact::position -> sensed_at;
#   contact_report::first -> has_priority
# - restart() of rate estimators and calibrations -> reset()
# - torque_range::smallest, largest -> lower, upper; hazard::longest -> max_time
