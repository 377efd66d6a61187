/// @file
/// A scene of many walls, made at run time.
#pragma once

#include <passive_haptics/scene/neighbour_list.hpp>
#include <passive_haptics/scene/strongest_contacts.hpp>

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace passive_haptics {

/// The walls of a world to be, numbered from 0 in the order in which they are added.
template <int D>
class world_walls {
 public:
  /// Adds a wall that stays where it is and returns its number.
  int add(any_wall<D> w) {
    walls_.push_back(std::move(w));
    return static_cast<int>(walls_.size()) - 1;
  }
  /// The same of a shape that is to be wrapped.
  template <class S>
  int add(const wall<S>& w) {
    return add(any_wall<D>(w));
  }

  /// Adds a wall that world::set_motion can move, and returns its number. Costs a comparison in each cycle that is not skipped.
  template <class S>
  int add_moving(const wall<S>& w) {
    moving_.push_back(add(w));
    return moving_.back();
  }

  /// All walls, by their numbers.
  const std::vector<any_wall<D>>& all() const { return walls_; }
  /// The numbers of those that may move.
  const std::vector<int>& moving() const { return moving_; }

 private:
  std::vector<any_wall<D>> walls_;
  std::vector<int> moving_;
};

/// What is wrong with the walls; empty if nothing.
template <int D>
std::string validate(const world_walls<D>& walls) {
  for (std::size_t i = 0; i < walls.all().size(); ++i) {
    const bounding_box<D>& b = walls.all()[i].bounds();
    if (!(b.lower.array() <= b.upper.array()).all())
      return detail::indexed(
          "bounds of wall ", i,
          " of a world are not lower <= upper, expected a box of finite or infinite metres");
  }
  return {};
}

/// Many walls, of which a cycle looks at those that the handle can have reached since it last looked: the contacts are those
/// of a scan over all of them (neighbour_list.hpp). At most Capacity contacts, those of the largest forces.
///
/// The walls are shared by copies and never change; each copy has its own memory of where the handle was. Walls with finite
/// bounds lie in a tree; the others, and those that move, are looked at one by one when they are due: keep them few.
/// Cost: a comparison where nothing can have been reached; neighbour_list.hpp. Construction O(n log n); it alone allocates.
template <int D, int Capacity = D + 1>
class world {
 public:
  static constexpr int dimension = D;           ///< d
  using contacts_type = contacts<D, Capacity>;  ///< What sensing this world gives.

  /// Throws std::invalid_argument with the text of validate(walls).
  explicit world(world_walls<D> walls) : geometry_(std::make_shared<const geometry>(require_valid(walls))) {
    near_ = neighbours(geometry_->others.size(), geometry_->tree.scale());
    motions_.resize(geometry_->walls.moving().size());
  }

  /// The contacts at x [m], in the order of their walls; valid until the next call. A NaN or infinity in x gives a contact
  /// with a NaN depth, which the step reports.
  const contacts_type& touched_at(const point<D>& x) {
    found_.clear();
    if (near_.idle(x)) return found_.in_order();
    if (!all_finite(x)) return undefined_contact();
    near_.visit(geometry_->tree, x, [&](int item) { return look(item, x); });
    return found_.in_order();
  }

  /// How many of the contacts at the latest x found no room.
  int left_out() const { return found_.left_out(); }

  /// Moves a wall that was added by add_moving: displacement from where it was made [m], velocity of its surface
  /// [m/s]; base frame. Two values, as of `moving`. False, and nothing moved, if there is no such wall or they are not finite.
  bool set_motion(int number, const point<D>& displacement, const point<D>& velocity) {
    const auto& moving = geometry_->walls.moving();
    const auto found = std::lower_bound(moving.begin(), moving.end(), number);
    if (found == moving.end() || *found != number || !all_finite(displacement, velocity)) return false;
    const auto k = static_cast<std::size_t>(found - moving.begin());
    near_.moved(k, (displacement - motions_[k].displacement).norm());
    motions_[k] = {displacement, velocity};
    return true;
  }

  /// Forgets where the handle was; for a new user, or after a fault.
  void reset() { near_.reset(); }

  /// The walls.
  const world_walls<D>& walls() const { return geometry_->walls; }

 private:
  using neighbours = neighbour_list<D>;

  // What never changes
  struct geometry {
    explicit geometry(world_walls<D> w) : walls(std::move(w)), others(walls.moving()) {
      std::vector<bounding_box<D>> boxes;
      std::vector<int> numbers;
      for (int i = 0; i < static_cast<int>(walls.all().size()); ++i) {
        const bounding_box<D>& b = walls.all()[static_cast<std::size_t>(i)].bounds();
        if (std::binary_search(walls.moving().begin(), walls.moving().end(), i)) continue;
        if (all_finite(b.lower, b.upper)) {
          boxes.push_back(b);
          numbers.push_back(i);
        } else {
          others.push_back(i);
        }
      }
      tree = bounding_volume_tree<D>(boxes);
      for (const auto i : tree.items()) in_tree.push_back(numbers[static_cast<std::size_t>(i)]);
      for (const auto i : in_tree) in_order.push_back(walls.all()[static_cast<std::size_t>(i)]);
    }

    world_walls<D> walls;
    std::vector<int> others;   // numbers of the walls outside the tree, the moving ones first
    std::vector<int> in_tree;  // number of the wall of each item
    bounding_volume_tree<D> tree;
    std::vector<any_wall<D>> in_order;
  };

  struct motion {
    point<D> displacement = point<D>::Zero();  // [m]
    point<D> velocity = point<D>::Zero();      // [m/s]
  };

  double look(int item, const point<D>& x) {
    const std::size_t other = static_cast<std::size_t>(-1 - item);
    const int number =
        item >= 0 ? geometry_->in_tree[static_cast<std::size_t>(item)] : geometry_->others[other];
    const any_wall<D>& w = item >= 0 ? geometry_->in_order[static_cast<std::size_t>(item)]
                                     : geometry_->walls.all()[static_cast<std::size_t>(number)];
    if (item >= 0 || other >= motions_.size()) {
      found_.from_wall(number, point<D>::Zero());
      return w.look(x, found_);
    }
    found_.from_wall(number, motions_[other].velocity);
    return w.look(x - motions_[other].displacement, found_);
  }

  const contacts_type& undefined_contact() {
    contact<D> c;
    c.depth = std::numeric_limits<double>::quiet_NaN();
    found_.from_wall(0, point<D>::Zero());
    found_.add(c);
    return found_.in_order();
  }

  std::shared_ptr<const geometry> geometry_;
  neighbours near_;
  std::vector<motion> motions_;  // in the order of walls.moving()
  strongest_contacts<D, Capacity> found_;
};

/// The contacts of a world at x [m].
template <int D, int Capacity>
const contacts<D, Capacity>& sense(world<D, Capacity>& walls, const point<D>& x) {
  return walls.touched_at(x);
}

}  // namespace passive_haptics
