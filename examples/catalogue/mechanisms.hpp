/// Mechanisms by name: one line for each, and one in CMakeLists.txt for a new kind of mechanism.
#pragma once

#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>
#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>

#include <string>

namespace example {

namespace ph = passive_haptics;

/// Parameters of a chain with inertia.
template <int N, int D>
struct heavy_chain_parameters {
  ph::serial_chain_parameters<double, N, D> geometry;  ///< Joints and handle.
  ph::serial_chain_inertia<double, N, D> inertia;      ///< Links, rotors, handle and gravity.

  static constexpr auto members() {
    using p = heavy_chain_parameters;
    return ph::member_table(ph::member("geometry", &p::geometry), ph::member("inertia", &p::inertia));
  }
};
/// A chain with inertia.
template <int N, int D>
struct heavy_chain : ph::serial_chain_with_inertia<double, N, D> {
  explicit heavy_chain(const heavy_chain_parameters<N, D>& p)
      : ph::serial_chain_with_inertia<double, N, D>(p.geometry, p.inertia) {}
};

/// Calls add<M, P>(name) for each mechanism M with parameters P.
template <class F>
void for_each_mechanism(F&& add) {
  add.template operator()<ph::tendon_two_link<double>, ph::tendon_two_link_parameters<double>>(
      "tendon_two_link");
  add.template operator()<ph::two_link<double>, ph::two_link_parameters<double>>("two_link");
  add.template operator()<ph::xy_table<double>, ph::xy_table_parameters<double>>("xy_table");
  add.template operator()<ph::five_bar<double>, ph::five_bar_parameters<double>>("five_bar");
  add.template operator()<ph::five_bar<double, 4>, ph::five_bar_parameters<double, 4>>(
      "five_bar_with_four_brakes");
  add.template operator()<ph::delta<double>, ph::delta_parameters<double>>("delta");
  const auto add_chain = [&]<int N, int D>(const std::string& name) {
    add.template operator()<ph::serial_chain<double, N, D>, ph::serial_chain_parameters<double, N, D>>(name);
    add.template operator()<heavy_chain<N, D>, heavy_chain_parameters<N, D>>(name + "_with_inertia");
  };
  add_chain.template operator()<2, 2>("planar_chain_2");
  add_chain.template operator()<3, 2>("planar_chain_3");
  add_chain.template operator()<4, 2>("planar_chain_4");
  add_chain.template operator()<3, 3>("spatial_chain_3");
  add_chain.template operator()<6, 3>("spatial_chain_6");
  add_chain.template operator()<7, 3>("spatial_chain_7");
}

}  // namespace example
