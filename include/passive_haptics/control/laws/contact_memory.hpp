/// @file
/// What a law remembers of each contact while it is touched.
#pragma once

#include <passive_haptics/scene/contacts.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace passive_haptics {

/// Memories of up to Capacity contacts touched at once. A law that has it names its Capacity as
/// `most_contacts`.
///
/// **The memory that a contact continues.** A wall number does not identify a contact: the faces of a mesh
/// share one, and at the seam of two walls the hand slides on along one surface while the number changes. A
/// memory is therefore found by wall and normal. Each cycle pairs its contacts with the memories of the cycle
/// before, the pair with the most similar normals first. Another wall's memory is continued only within 30
/// degrees, where a force learned along the normal is right to 13 %, and only if the wall's own is not as
/// similar or has turned by more than that. A contact without a partner begins with a fresh memory; a memory
/// without one is forgotten.
template <class Memory, int Capacity>
class contact_memory {
 public:
  static constexpr int capacity = Capacity;  ///< Contacts at once.

  /// To be called at the beginning of a cycle, with its contacts. Those beyond Capacity share a memory.
  template <class Contacts>
  void begin_cycle(const Contacts& touched) {
    const int before = size_;
    size_ = std::min(touched.size(), Capacity);
    const bool continues = size_ == 1 && before == 1 && touched[0].wall_number == slots_[0].wall;  // the pair
    if (!continues) pair(touched, before);
    for (int j = 0; j < size_; ++j) slots_[std::size_t(j)].set_contact(touched[j]);
  }

  /// The memory of contact j of this cycle.
  Memory& operator[](int j) { return slots_[std::size_t(std::min(j, Capacity - 1))].memory; }

  /// Forgets all contacts.
  void clear() { size_ = 0; }

 private:
  static constexpr int max_dimension = 3;        // as of a mechanism's task
  static constexpr double least_cosine = 0.866;  // between the normals of a contact and another wall's memory

  struct slot {
    int wall = 0;
    std::array<float, max_dimension> normal = {};  // exact enough to compare
    Memory memory = {};

    template <class Contact>
    void set_contact(const Contact& c) {
      wall = c.wall_number;
      for (int i = 0; i < int(c.normal.size()); ++i) normal[std::size_t(i)] = float(c.normal[i]);
    }
    // Not above `unlike` if the contact cannot continue this memory
    template <class Contact>
    double similarity(const Contact& c) const {
      double cosine = 0;
      for (int i = 0; i < int(c.normal.size()); ++i) cosine += c.normal[i] * double(normal[std::size_t(i)]);
      if (c.wall_number == wall) return cosine + 1 - least_cosine;
      return cosine > least_cosine ? cosine : unlike;
    }
  };
  static constexpr double unlike = -1;

  static bool holds(unsigned set, int k) { return (set >> k & 1u) != 0; }

  // Brings the memory of each contact to its place
  template <class Contacts>
  void pair(const Contacts& touched, int before) {
    unsigned open = (1u << size_) - 1, known = (1u << before) - 1;  // contacts and memories without a partner
    for (;;) {
      double most = unlike;
      int contact = 0, memory = 0;
      for (int j = 0; j < size_; ++j) {
        for (int k = 0; k < before; ++k) {
          if (!holds(open, j) || !holds(known, k)) continue;
          const double similarity = slots_[std::size_t(k)].similarity(touched[j]);
          if (!(similarity > most)) continue;
          most = similarity;
          contact = j;
          memory = k;
        }
      }
      if (most == unlike) break;
      std::swap(slots_[std::size_t(contact)], slots_[std::size_t(memory)]);
      open &= ~(1u << contact);
      known &= ~(1u << (holds(known, contact) ? contact : memory));  // what was there is at `memory` now
    }
    for (int j = 0; j < size_; ++j)
      if (holds(open, j)) slots_[std::size_t(j)].memory = {};
  }

  std::array<slot, static_cast<std::size_t>(Capacity)> slots_{};
  int size_ = 0;  // contacts of this cycle
};

}  // namespace passive_haptics
