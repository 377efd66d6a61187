/// @file
/// Devices of mechanisms that are known at run time only, for each size that the module has controllers for.
#pragma once

#include <passive_haptics_python/any_device.hpp>
#include <passive_haptics_python/any_mechanism.hpp>
#include <passive_haptics_python/laws.hpp>

#include <passive_haptics/control/laws/on_off_control.hpp>

#include <memory>

namespace passive_haptics_python {

/// The laws of these devices.
using any_device_laws = law_list<ph::direct_control, ph::saturated_direct_control, ph::on_off_control,
                                 ph::velocity_direct_control>;
/// Without velocity_direct_control, for sizes that have no inertia in this module.
using massless_device_laws = law_list<ph::direct_control, ph::saturated_direct_control, ph::on_off_control>;

/// Two joints in the plane.
using any_pair = any_mechanism<2, 2, true>;
/// Six or seven joints in space.
template <int N>
using any_long_chain = any_mechanism<N, 3, false, false>;

// Each is defined where the controllers of its size are compiled. has_inertia: of what is held.
std::unique_ptr<any_device> device_for(any_pair mechanism, bool has_inertia);
std::unique_ptr<any_device> device_for(any_mechanism<3, 2> mechanism, bool has_inertia);
std::unique_ptr<any_device> device_for(any_mechanism<4, 2> mechanism, bool has_inertia);
std::unique_ptr<any_device> device_for(any_mechanism<3, 3> mechanism, bool has_inertia);
std::unique_ptr<any_device> device_for(any_long_chain<6> mechanism, bool has_inertia);
std::unique_ptr<any_device> device_for(any_long_chain<7> mechanism, bool has_inertia);

}  // namespace passive_haptics_python
