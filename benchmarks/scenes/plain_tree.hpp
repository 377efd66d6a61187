// The walls of a world by a tree of their boxes, searched in each cycle: the cost of a world when the handle
// jumps.
#pragma once

#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/scene/bounds/bounding_volume_tree.hpp>
#include <passive_haptics/scene/world/strongest_contacts.hpp>
#include <passive_haptics/scene/world/world_walls.hpp>

#include <vector>

namespace plain {

namespace ph = passive_haptics;

class tree_of_walls {
 public:
  explicit tree_of_walls(const ph::world_walls<3>& walls) : walls_(walls.all()) {
    std::vector<ph::bounding_box<3>> boxes;
    for (std::size_t i = 0; i < walls_.size(); ++i) {
      const auto& box = walls_[i].bounds();
      const bool bounded = ph::all_finite(box.lower, box.upper);
      (bounded ? in_tree_ : unbounded_).push_back(i);
      if (bounded) boxes.push_back(box);
    }
    tree_ = ph::bounding_volume_tree<3>(boxes);
  }

  const ph::contacts<3, 4>& touched_at(const ph::point<3>& x) {
    found_.clear();
    for (const std::size_t i : unbounded_) look(i, x);
    tree_.visit_within(ph::squared_distance_from<3>(x), 0.0, [&](int place, double) {
      look(in_tree_[static_cast<std::size_t>(tree_.item(place))], x);
    });
    return found_.in_order();
  }

 private:
  void look(std::size_t i, const ph::point<3>& x) {
    touched_.clear();
    walls_[i].look(x, x, 0, nullptr, touched_);
    for (ph::contact<3>& c : touched_) {
      c.wall_number = static_cast<int>(i);
      c.sensed_at = x;
      found_.add(c);
    }
  }

  std::vector<ph::any_wall<3>> walls_;
  std::vector<std::size_t> in_tree_, unbounded_;
  ph::bounding_volume_tree<3> tree_;
  ph::contacts<3, 3> touched_;
  ph::strongest_contacts<3, 4> found_;
};

}  // namespace plain
