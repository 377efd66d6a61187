/// @file
/// What a law remembers of each wall while it is touched.
#pragma once

#include <array>

namespace passive_haptics {

/// Memories of up to Capacity walls touched at once, found by the wall's number. A wall that was not touched
/// in the cycle before begins with a fresh one. A law that has it names its Capacity as `most_contacts`.
template <class Memory, int Capacity>
class contact_memory {
 public:
  static constexpr int capacity = Capacity;  ///< Walls at once.

  /// To be called at the beginning of a cycle: forgets walls that were not touched in the last one.
  void begin_cycle() {
    for (slot& s : slots_) {
      s.known = s.touched;
      s.touched = false;
    }
  }

  /// The memory of this wall. Where no memory is free, it is taken from a wall that is not touched in this
  /// cycle so far. Not for more than Capacity walls in a cycle.
  Memory& of(int wall) {
    slot *free = nullptr, *untouched = nullptr;
    for (slot& s : slots_) {
      if ((s.known || s.touched) && s.wall == wall) {
        s.touched = true;
        return s.memory;
      }
      if (free == nullptr && !s.known && !s.touched) free = &s;
      if (untouched == nullptr && !s.touched) untouched = &s;
    }
    if (free == nullptr) free = untouched != nullptr ? untouched : &slots_.back();
    *free = {.wall = wall, .touched = true};
    return free->memory;
  }

  /// Forgets all walls.
  void clear() {
    for (slot& s : slots_) s.known = s.touched = false;
  }

 private:
  struct slot {
    int wall = 0;
    bool known = false;    // touched in the cycle before
    bool touched = false;  // touched in this one
    Memory memory = {};
  };
  std::array<slot, static_cast<std::size_t>(Capacity)> slots_{};
};

}  // namespace passive_haptics
