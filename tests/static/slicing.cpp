// No part of the library loses by a copy what makes it another device, law, brake or shape.
#include <passive_haptics/passive_haptics.hpp>

#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/plant/brakes/compensated_brake.hpp>
#include <passive_haptics/plant/brakes/delayed_brake.hpp>
#include <passive_haptics/plant/brakes/stribeck_brake.hpp>

#include <array>
#include <type_traits>

namespace ph = passive_haptics;

namespace {

// Whether a value of type From stands where a To is expected, as a copy, by assignment or in a return.
template <class To, class From>
inline constexpr bool becomes =
    std::is_constructible_v<To, const From&> || std::is_constructible_v<To, From> ||
    std::is_assignable_v<To&, const From&> || std::is_assignable_v<To&, From> ||
    std::is_convertible_v<const From&, To> || std::is_convertible_v<From, To>;

using two_link = ph::two_link<double>;
using tendon = ph::tendon_two_link<double>;
static_assert(becomes<two_link, two_link> && becomes<tendon, tendon>, "copies of the whole");
static_assert(!becomes<two_link, tendon>, "the tendon would be lost");
struct scara : two_link {
  ph::matrix<double, 2, 2> transmission() const { return ph::matrix<double, 2, 2>{{1, 0}, {3, 3}}; }
};
static_assert(becomes<scara, scara> && !becomes<two_link, scara>, "a user's transmission");

using chain = ph::serial_chain<double, 3, 2>;
using chain_with_inertia = ph::serial_chain_with_inertia<double, 3, 2>;
static_assert(becomes<chain, chain> && becomes<chain_with_inertia, chain_with_inertia>);
static_assert(!becomes<chain, chain_with_inertia>, "the inertia would be lost");
using lower = ph::braked_joints<chain_with_inertia, 0, 1>;
static_assert(becomes<lower, lower>);
static_assert(!becomes<chain_with_inertia, lower> && !becomes<chain, lower>);

using five_bar = ph::five_bar<double, 4>;
static_assert(becomes<five_bar, five_bar>);
static_assert(!becomes<ph::leg_chain<five_bar, double, 2>, five_bar>);

using coulomb = ph::coulomb_brake<double>;
static_assert(!becomes<coulomb, ph::stribeck_brake<double>>);
static_assert(!becomes<coulomb, ph::delayed_brake<coulomb>>);
static_assert(!becomes<coulomb, ph::compensated_brake<coulomb>>);
using rate_limited = ph::rate_limited_brakes<tendon, coulomb>;
static_assert(becomes<rate_limited, rate_limited> && becomes<rate_limited, ph::brakes_of<tendon>>);
static_assert(!becomes<ph::brakes_of<tendon>, rate_limited>, "the limits of the moment would be lost");
using switchable = ph::switchable_brakes<tendon>;
static_assert(becomes<switchable, ph::brakes_of<tendon>> && becomes<rate_limited, switchable>);
static_assert(!becomes<ph::brakes_of<tendon>, switchable>, "which brakes are off would be lost");
static_assert(!becomes<switchable, rate_limited>, "the limits of the moment would be lost");
static_assert(!std::is_convertible_v<const rate_limited&, const ph::brakes_of<tendon>&>);

static_assert(!becomes<ph::direct_control, ph::saturated_direct_control>);
static_assert(!becomes<ph::saturated_direct_control, ph::direct_control>);

using plane = ph::half_space<2>;
static_assert(becomes<ph::offset<plane>, ph::offset<plane>>);
static_assert(!becomes<ph::shape_wrapper<plane>, ph::offset<plane>> && !becomes<plane, ph::offset<plane>>);
static_assert(!becomes<ph::shape_wrapper<plane>, ph::moving<plane>> &&
              !becomes<ph::shape_wrapper<plane>, ph::complement<plane>>);

}  // namespace
