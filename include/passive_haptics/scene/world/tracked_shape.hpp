/// The TrackedShape concept: walls that remember the side of the handle.
#pragma once

#include <passive_haptics/scene/bounds/bounding_box.hpp>

#include <concepts>
#include <type_traits>

namespace passive_haptics {

/// The geometry of a wall that follows the handle. It may be thin, open, and touched at several places.
///
/// Minimal complete definition:
///   - `static constexpr int dimension`;
///   - `tracker`: the state for one handle; trivially copyable, by default empty;
///   - `bounding_box<dimension> bounds() const`: a free handle outside touches nothing. A handle that has
///     been stopped may be pushed out of it and still be held;
///   - `double follow(const point<dimension>& from, const point<dimension>& x, tracker& t, Add&& add) const`:
///     the handle has moved straight from `from` in the previous cycle to x [m]. Calls `add(normal, depth)`
///     for each contact, at most `dimension`, with the outward unit normal and the depth [m] > 0. Returns the
///     distance that the handle may move before the next call [m]; 0 during contact.
///
/// Laws: the result of follow depends only on `from`, x and t. NaN in x adds a contact with a NaN depth and
/// leaves t unchanged. follow never allocates, and its time is bounded for all x.
/// testing/tracked_shape_properties.hpp checks all laws except the last.
template <class S>
concept TrackedShape = detail::names_dimension<S> && std::is_trivially_copyable_v<typename S::tracker> &&
                       std::default_initializable<typename S::tracker> &&
                       requires(const S shape, const point<S::dimension> x, typename S::tracker t,
                                void (*add)(const point<S::dimension>&, double)) {
                         { shape.bounds() } -> std::same_as<bounding_box<S::dimension>>;
                         { shape.follow(x, x, t, add) } -> std::same_as<double>;
                       };

}  // namespace passive_haptics
