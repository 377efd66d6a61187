/// Forward declaration of simulated_device, so that an error can name the missing header.
#pragma once

namespace passive_haptics {

template <class T>
struct coulomb_brake;

namespace detail {

struct simulated_device_header;  // complete once plant/simulated_device.hpp is included

template <class M, class Header = simulated_device_header>
consteval bool has_simulated_device() {
  static_assert(
      requires { sizeof(Header); },
      "passive_haptics: simulated_device needs #include <passive_haptics/plant/simulated_device.hpp>.");
  return true;
}

}  // namespace detail

template <class M, class Model = coulomb_brake<typename M::scalar>>
  requires(detail::has_simulated_device<M>())
class simulated_device;

}  // namespace passive_haptics
