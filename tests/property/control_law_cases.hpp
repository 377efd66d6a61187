// Control laws with the parameters and devices that their property suite takes them through.
#pragma once

#include "custom_cases.hpp"
#include "device_cases.hpp"

#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/laws/on_off_control.hpp>
#include <passive_haptics/testing/control_law_properties.hpp>
#include <passive_haptics/testing/fault_properties.hpp>

struct nulling_early : passive_haptics::direct_control {
  nulling_early() { velocity_dead_band = 0.05; }
};

template <class Law>
using on_tendon_device = ::testing::Types<
    passive_haptics::testing::law_case<device_case<passive_haptics::tendon_two_link<double>>, Law>>;
template <class Law>
using on_other_devices =
    ::testing::Types<passive_haptics::testing::law_case<device_case<passive_haptics::xy_table<float>>, Law>,
                     passive_haptics::testing::law_case<custom_case<custom::spatial_arm<double>>, Law>>;
