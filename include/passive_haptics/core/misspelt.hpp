/// @file
/// Optional members whose names are misspelt: without a check they would count as absent, and the device
/// would be another one in silence.
#pragma once

namespace passive_haptics::detail {

/// @cond
// misspells_name<X>: X has no member `name`, but one that lacks a letter or an underscore of it. A member
// that is overloaded or a template is not found.
#define PASSIVE_HAPTICS_MISSPELT(name, ...) \
  template <class X>                        \
  concept misspells_##name =                \
      !requires { &X::name; } && (PASSIVE_HAPTICS_4(PASSIVE_HAPTICS_ANY(X, __VA_ARGS__)));
#define PASSIVE_HAPTICS_ANY(X, name, ...) \
  requires { &X::name; } __VA_OPT__(|| PASSIVE_HAPTICS_ANY_AGAIN PASSIVE_HAPTICS_NOTHING(X, __VA_ARGS__))
#define PASSIVE_HAPTICS_ANY_AGAIN() PASSIVE_HAPTICS_ANY
#define PASSIVE_HAPTICS_NOTHING ()
// Scans its arguments again and again, once for each name
#define PASSIVE_HAPTICS_4(...) PASSIVE_HAPTICS_3(PASSIVE_HAPTICS_3(PASSIVE_HAPTICS_3(__VA_ARGS__)))
#define PASSIVE_HAPTICS_3(...) PASSIVE_HAPTICS_2(PASSIVE_HAPTICS_2(PASSIVE_HAPTICS_2(__VA_ARGS__)))
#define PASSIVE_HAPTICS_2(...) PASSIVE_HAPTICS_1(PASSIVE_HAPTICS_1(PASSIVE_HAPTICS_1(__VA_ARGS__)))
#define PASSIVE_HAPTICS_1(...) __VA_ARGS__

// clang-format off
PASSIVE_HAPTICS_MISSPELT(jacobian, acobian, jcobian, jaobian, jacbian, jacoian, jacoban, jacobia)
PASSIVE_HAPTICS_MISSPELT(transmission, ransmission, tansmission, trnsmission, trasmission, tranmission,
    transission, transmssion, transmision, transmisson, transmissin, transmissio)
PASSIVE_HAPTICS_MISSPELT(mass_matrix, ass_matrix, mss_matrix, mas_matrix, massmatrix, mass_atrix,
    mass_mtrix, mass_marix, mass_matix, mass_matrx, mass_matri)
PASSIVE_HAPTICS_MISSPELT(bias_torque, ias_torque, bas_torque, bis_torque, bia_torque, biastorque,
    bias_orque, bias_trque, bias_toque, bias_torue, bias_torqe, bias_torqu)
PASSIVE_HAPTICS_MISSPELT(bias_acceleration, ias_acceleration, bas_acceleration, bis_acceleration,
    bia_acceleration, biasacceleration, bias_cceleration, bias_aceleration, bias_accleration,
    bias_acceeration, bias_accelration, bias_acceleation, bias_accelertion, bias_acceleraion,
    bias_acceleraton, bias_acceleratin, bias_acceleratio)
PASSIVE_HAPTICS_MISSPELT(inverse_jacobian, nverse_jacobian, iverse_jacobian, inerse_jacobian,
    invrse_jacobian, invese_jacobian, invere_jacobian, invers_jacobian, inversejacobian, inverse_acobian,
    inverse_jcobian, inverse_jaobian, inverse_jacbian, inverse_jacoian, inverse_jacoban, inverse_jacobin,
    inverse_jacobia)
PASSIVE_HAPTICS_MISSPELT(inverse_transposed_jacobian, nverse_transposed_jacobian,
    iverse_transposed_jacobian, inerse_transposed_jacobian, invrse_transposed_jacobian,
    invese_transposed_jacobian, invere_transposed_jacobian, invers_transposed_jacobian,
    inversetransposed_jacobian, inverse_ransposed_jacobian, inverse_tansposed_jacobian,
    inverse_trnsposed_jacobian, inverse_trasposed_jacobian, inverse_tranposed_jacobian,
    inverse_transosed_jacobian, inverse_transpsed_jacobian, inverse_transpoed_jacobian,
    inverse_transposd_jacobian, inverse_transpose_jacobian, inverse_transposedjacobian,
    inverse_transposed_acobian, inverse_transposed_jcobian, inverse_transposed_jaobian,
    inverse_transposed_jacbian, inverse_transposed_jacoian, inverse_transposed_jacoban,
    inverse_transposed_jacobin, inverse_transposed_jacobia)
PASSIVE_HAPTICS_MISSPELT(self_motion, elf_motion, slf_motion, sef_motion, sel_motion, selfmotion, self_otion,
    self_mtion, self_moion, self_moton, self_motin, self_motio)
PASSIVE_HAPTICS_MISSPELT(torque_limit, orque_limit, trque_limit, toque_limit, torue_limit, torqe_limit,
    torqu_limit, torquelimit, torque_imit, torque_lmit, torque_liit, torque_limt, torque_limi)
PASSIVE_HAPTICS_MISSPELT(torque_lower, orque_lower, trque_lower, toque_lower, torue_lower, torqe_lower,
    torqu_lower, torquelower, torque_ower, torque_lwer, torque_loer, torque_lowr, torque_lowe)
PASSIVE_HAPTICS_MISSPELT(torque_upper, orque_upper, trque_upper, toque_upper, torue_upper, torqe_upper,
    torqu_upper, torqueupper, torque_pper, torque_uper, torque_uppr, torque_uppe)
PASSIVE_HAPTICS_MISSPELT(rate_dead_band, ate_dead_band, rte_dead_band, rae_dead_band, rat_dead_band,
    ratedead_band, rate_ead_band, rate_dad_band, rate_ded_band, rate_dea_band, rate_deadband, rate_dead_and,
    rate_dead_bnd, rate_dead_bad, rate_dead_ban)
PASSIVE_HAPTICS_MISSPELT(torque_dead_band, orque_dead_band, trque_dead_band, toque_dead_band,
    torue_dead_band, torqe_dead_band, torqu_dead_band, torquedead_band, torque_ead_band, torque_dad_band,
    torque_ded_band, torque_dea_band, torque_deadband, torque_dead_and, torque_dead_bnd, torque_dead_bad,
    torque_dead_ban)
PASSIVE_HAPTICS_MISSPELT(time_constant, ime_constant, tme_constant, tie_constant, tim_constant,
    timeconstant, time_onstant, time_cnstant, time_costant, time_contant, time_consant, time_constnt,
    time_constat, time_constan)
PASSIVE_HAPTICS_MISSPELT(needs_hand_force, eeds_hand_force, neds_hand_force, nees_hand_force,
    need_hand_force, needshand_force, needs_and_force, needs_hnd_force, needs_had_force, needs_han_force,
    needs_handforce, needs_hand_orce, needs_hand_frce, needs_hand_foce, needs_hand_fore, needs_hand_forc)
PASSIVE_HAPTICS_MISSPELT(needs_dynamics, eeds_dynamics, neds_dynamics, nees_dynamics, need_dynamics,
    needsdynamics, needs_ynamics, needs_dnamics, needs_dyamics, needs_dynmics, needs_dynaics, needs_dynamcs,
    needs_dynamis, needs_dynamic)
PASSIVE_HAPTICS_MISSPELT(needs_brake_lag, eeds_brake_lag, neds_brake_lag, nees_brake_lag, need_brake_lag,
    needsbrake_lag, needs_rake_lag, needs_bake_lag, needs_brke_lag, needs_brae_lag, needs_brak_lag,
    needs_brakelag, needs_brake_ag, needs_brake_lg, needs_brake_la)
PASSIVE_HAPTICS_MISSPELT(needs_torque_limit, eeds_torque_limit, neds_torque_limit, nees_torque_limit,
    need_torque_limit, needstorque_limit, needs_orque_limit, needs_trque_limit, needs_toque_limit,
    needs_torue_limit, needs_torqe_limit, needs_torqu_limit, needs_torquelimit, needs_torque_imit,
    needs_torque_lmit, needs_torque_liit, needs_torque_limt, needs_torque_limi)
PASSIVE_HAPTICS_MISSPELT(needs_sensed_at, eeds_sensed_at, neds_sensed_at, nees_sensed_at, need_sensed_at,
    needssensed_at, needs_ensed_at, needs_snsed_at, needs_sesed_at, needs_sened_at, needs_sensd_at,
    needs_sense_at, needs_sensedat, needs_sensed_t, needs_sensed_a)
PASSIVE_HAPTICS_MISSPELT(needs_rising_time, eeds_rising_time, neds_rising_time, nees_rising_time,
    need_rising_time, needsrising_time, needs_ising_time, needs_rsing_time, needs_riing_time,
    needs_risng_time, needs_risig_time, needs_risin_time, needs_risingtime, needs_rising_ime,
    needs_rising_tme, needs_rising_tie, needs_rising_tim)
PASSIVE_HAPTICS_MISSPELT(nulls_normal_force, ulls_normal_force, nlls_normal_force, nuls_normal_force,
    null_normal_force, nullsnormal_force, nulls_ormal_force, nulls_nrmal_force, nulls_nomal_force,
    nulls_noral_force, nulls_norml_force, nulls_norma_force, nulls_normalforce, nulls_normal_orce,
    nulls_normal_frce, nulls_normal_foce, nulls_normal_fore, nulls_normal_forc)
PASSIVE_HAPTICS_MISSPELT(saturates_before_scaling, aturates_before_scaling, sturates_before_scaling,
    saurates_before_scaling, satrates_before_scaling, satuates_before_scaling, saturtes_before_scaling,
    saturaes_before_scaling, saturats_before_scaling, saturate_before_scaling, saturatesbefore_scaling,
    saturates_efore_scaling, saturates_bfore_scaling, saturates_beore_scaling, saturates_befre_scaling,
    saturates_befoe_scaling, saturates_befor_scaling, saturates_beforescaling, saturates_before_caling,
    saturates_before_saling, saturates_before_scling, saturates_before_scaing, saturates_before_scalng,
    saturates_before_scalig, saturates_before_scalin)
PASSIVE_HAPTICS_MISSPELT(commands_torques, ommands_torques, cmmands_torques, comands_torques,
    commnds_torques, commads_torques, commans_torques, command_torques, commandstorques, commands_orques,
    commands_trques, commands_toques, commands_torues, commands_torqes, commands_torqus, commands_torque)
PASSIVE_HAPTICS_MISSPELT(most_contacts, ost_contacts, mst_contacts, mot_contacts, mos_contacts,
    mostcontacts, most_ontacts, most_cntacts, most_cotacts, most_conacts, most_contcts, most_contats,
    most_contacs, most_contact)
PASSIVE_HAPTICS_MISSPELT(hand_force, and_force, hnd_force, had_force, han_force, handforce, hand_orce,
    hand_frce, hand_foce, hand_fore, hand_forc)
PASSIVE_HAPTICS_MISSPELT(hand_torque, and_torque, hnd_torque, had_torque, han_torque, handtorque,
    hand_orque, hand_trque, hand_toque, hand_torue, hand_torqe, hand_torqu)
// clang-format on

#undef PASSIVE_HAPTICS_MISSPELT
#undef PASSIVE_HAPTICS_ANY
#undef PASSIVE_HAPTICS_ANY_AGAIN
#undef PASSIVE_HAPTICS_NOTHING
#undef PASSIVE_HAPTICS_4
#undef PASSIVE_HAPTICS_3
#undef PASSIVE_HAPTICS_2
#undef PASSIVE_HAPTICS_1
/// @endcond

// The names of the optional members of a mechanism, one short message for each.
template <class X>
struct mechanism_spelling {
  static_assert(!misspells_jacobian<X>,
                "passive_haptics: a member of the mechanism is spelt almost as `jacobian`, which it lacks: "
                "correct the name.");
  static_assert(!misspells_transmission<X>,
                "passive_haptics: a member of the mechanism is spelt almost as `transmission`, which it "
                "lacks: correct the name.");
  static_assert(!misspells_mass_matrix<X>,
                "passive_haptics: a member of the mechanism is spelt almost as `mass_matrix`, which it "
                "lacks: correct the name.");
  static_assert(!misspells_bias_torque<X>,
                "passive_haptics: a member of the mechanism is spelt almost as `bias_torque`, which it "
                "lacks: correct the name.");
  static_assert(!misspells_bias_acceleration<X>,
                "passive_haptics: a member of the mechanism is spelt almost as `bias_acceleration`, which it "
                "lacks: correct the name.");
  static_assert(!misspells_inverse_jacobian<X>,
                "passive_haptics: a member of the mechanism is spelt almost as `inverse_jacobian`, which it "
                "lacks: correct the name.");
  static_assert(!misspells_inverse_transposed_jacobian<X>,
                "passive_haptics: a member of the mechanism is spelt almost as "
                "`inverse_transposed_jacobian`, which it lacks: correct the name.");
  static_assert(!misspells_self_motion<X>,
                "passive_haptics: a member of the mechanism is spelt almost as `self_motion`, which it "
                "lacks: correct the name.");
  static constexpr bool met = true;
};

// The names of the members of brakes, one short message for each.
template <class X>
struct brakes_spelling {
  static_assert(!misspells_torque_limit<X>,
                "passive_haptics: a member of the brakes is spelt almost as `torque_limit`, which it lacks: "
                "correct the name.");
  static_assert(!misspells_torque_lower<X>,
                "passive_haptics: a member of the brakes is spelt almost as `torque_lower`, which it lacks: "
                "correct the name.");
  static_assert(!misspells_torque_upper<X>,
                "passive_haptics: a member of the brakes is spelt almost as `torque_upper`, which it lacks: "
                "correct the name.");
  static_assert(!misspells_rate_dead_band<X>,
                "passive_haptics: a member of the brakes is spelt almost as `rate_dead_band`, which it "
                "lacks: correct the name.");
  static_assert(!misspells_torque_dead_band<X>,
                "passive_haptics: a member of the brakes is spelt almost as `torque_dead_band`, which it "
                "lacks: correct the name.");
  static_assert(!misspells_time_constant<X>,
                "passive_haptics: a member of the brakes is spelt almost as `time_constant`, which it lacks: "
                "correct the name.");
  static constexpr bool met = true;
};

// The names of the optional members of a law, one short message for each.
template <class X>
struct law_spelling {
  static_assert(!misspells_needs_hand_force<X>,
                "passive_haptics: a member of the law is spelt almost as `needs_hand_force`, which it lacks: "
                "correct the name.");
  static_assert(!misspells_needs_dynamics<X>,
                "passive_haptics: a member of the law is spelt almost as `needs_dynamics`, which it lacks: "
                "correct the name.");
  static_assert(!misspells_needs_brake_lag<X>,
                "passive_haptics: a member of the law is spelt almost as `needs_brake_lag`, which it lacks: "
                "correct the name.");
  static_assert(!misspells_needs_torque_limit<X>,
                "passive_haptics: a member of the law is spelt almost as `needs_torque_limit`, which it "
                "lacks: correct the name.");
  static_assert(!misspells_needs_sensed_at<X>,
                "passive_haptics: a member of the law is spelt almost as `needs_sensed_at`, which it lacks: "
                "correct the name.");
  static_assert(
      !misspells_needs_rising_time<X>,
      "passive_haptics: a member of the law is spelt almost as `needs_rising_time`, which it lacks: "
      "correct the name.");
  static_assert(!misspells_nulls_normal_force<X>,
                "passive_haptics: a member of the law is spelt almost as `nulls_normal_force`, which it "
                "lacks: correct the name.");
  static_assert(!misspells_saturates_before_scaling<X>,
                "passive_haptics: a member of the law is spelt almost as `saturates_before_scaling`, which "
                "it lacks: correct the name.");
  static_assert(!misspells_commands_torques<X>,
                "passive_haptics: a member of the law is spelt almost as `commands_torques`, which it lacks: "
                "correct the name.");
  static_assert(!misspells_most_contacts<X>,
                "passive_haptics: a member of the law is spelt almost as `most_contacts`, which it lacks: "
                "correct the name.");
  static constexpr bool met = true;
};

// The names of the optional members of a state, one short message for each.
template <class X>
struct state_spelling {
  static_assert(!misspells_hand_force<X>,
                "passive_haptics: a member of the state is spelt almost as `hand_force`, which it lacks: "
                "correct the name.");
  static_assert(!misspells_hand_torque<X>,
                "passive_haptics: a member of the state is spelt almost as `hand_torque`, which it lacks: "
                "correct the name.");
  static constexpr bool met = true;
};

}  // namespace passive_haptics::detail
