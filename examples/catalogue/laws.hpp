/// The control laws by name: one line for each.
#pragma once

#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/laws/on_off_control.hpp>
#include <passive_haptics/control/laws/saturated_direct_control.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/runtime/catalogue.hpp>

#include <tuple>

namespace example {

namespace ph = passive_haptics;

/// All laws. The default of a device file is the first one that its device can use.
inline constexpr std::tuple laws{
    ph::runtime::named_law<ph::velocity_direct_control>{"velocity_direct_control"},
    ph::runtime::named_law<ph::on_off_control>{"on_off_control"},
    ph::runtime::named_law<ph::direct_control>{"direct_control"},
    ph::runtime::named_law<ph::saturated_direct_control>{"saturated_direct_control"},
    ph::runtime::named_law<ph::no_direct_control>{"no_direct_control"},
};

}  // namespace example
