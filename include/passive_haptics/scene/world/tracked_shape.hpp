/// @file
/// The TrackedShape concept: a wall that remembers on which side the handle was.
#pragma once

#include <passive_haptics/scene/bounds/bounding_box.hpp>

#include <concepts>
#include <type_traits>

namespace passive_haptics {

/// A wall's geometry that a handle is followed along, so that it may be thin, open and touched at several
/// places at once.
///
/// Minimal complete definition:
///   - `static constexpr int dimension`;
///   - `tracker`: what is remembered of one handle. Trivially copyable; a new one remembers nothing;
///   - `bounding_box<dimension> bounds() const`: a handle that touches nothing and stays outside will touch
///     nothing. One that has been stopped may be pushed out of it and still be held;
///   - `double follow(const point<dimension>& from, const point<dimension>& x, tracker& t, Add&& add) const`:
///     the handle is at x [m] and was at `from` a cycle before, a straight way between. Calls
///     `add(normal, depth)` for each contact, at most `dimension` of them: unit vector out of the wall,
///     penetration [m] > 0. Returns how far [m] from x the handle may go, any way, before it must be followed
///     again; 0 while it touches.
///
/// Laws: what follow adds depends on `from`, x and t alone. A NaN in x adds a contact with a NaN depth, so
/// that no step mistakes it for free space, and leaves t alone. It never allocates, and takes a bounded time
/// however far x is. testing/tracked_shape_properties.hpp checks all but the last.
template <class S>
concept TrackedShape = detail::names_dimension<S> && std::is_trivially_copyable_v<typename S::tracker> &&
                       std::default_initializable<typename S::tracker> &&
                       requires(const S shape, const point<S::dimension> x, typename S::tracker t,
                                void (*add)(const point<S::dimension>&, double)) {
                         { shape.bounds() } -> std::same_as<bounding_box<S::dimension>>;
                         { shape.follow(x, x, t, add) } -> std::same_as<double>;
                       };

}  // namespace passive_haptics
