/// @file
/// What the classes of scenes have in common.
#pragma once

#include <passive_haptics_python/scenes.hpp>

namespace passive_haptics_python {

/// A scene of class Scene, which has a template scene_in<D, Capacity>().
template <class Scene>
struct kind_of_scene : scene {
  using scene::scene;
  any_scene<2> made(std::type_identity<any_scene<2>>) const override { return in<2, 3>(); }
  any_scene<2, 1> made(std::type_identity<any_scene<2, 1>>) const override { return in<2, 1>(); }
  any_scene<3> made(std::type_identity<any_scene<3>>) const override { return in<3, 4>(); }
  any_scene<3, 1> made(std::type_identity<any_scene<3, 1>>) const override { return in<3, 1>(); }

 private:
  template <int D, int Capacity>
  any_scene<D, Capacity> in() const {
    return static_cast<const Scene&>(*this).template scene_in<D, Capacity>();
  }
};

}  // namespace passive_haptics_python
