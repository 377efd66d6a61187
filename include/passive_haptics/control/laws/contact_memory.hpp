/// @file
/// Memory that a law has of each contact while it is touched.
#pragma once

#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/scene/contacts.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace passive_haptics {

/// Memories of up to Capacity contacts touched at once. A law that has it names its Capacity as
/// `max_contacts`.
///
/// **The memory that a contact continues.** A wall number does not identify a contact: the faces of a mesh
/// share one, and at the seam of two walls the hand slides on along one surface while the number changes. A
/// memory therefore belongs to a wall and a normal. Each cycle pairs its contacts with the memories of the
/// cycle before, the most similar normals first. A contact continues a memory of its own wall however far the
/// normal has turned, and one of another wall if the normals differ by less than 30 degrees: a force learned
/// along one is then right along the other to 13 %. Between both, its own wall counts as much as these
/// 30 degrees do. A contact without a partner begins with a fresh memory; a memory without one is forgotten.
template <class Memory, int Capacity>
class contact_memory {
 public:
  static constexpr int capacity = Capacity;  ///< Contacts at once.

  /// To be called at the beginning of a cycle, with its contacts. Those beyond Capacity share a memory.
  template <class Contacts>
  void begin_cycle(const Contacts& touched) {
    const int before = size_;
    size_ = std::min(touched.size(), Capacity);
    int paired = 0;  // contacts as before, in most cycles all
    while (paired < std::min(size_, before) && nth(slots_, paired).is_of(touched[paired])) ++paired;
    if (paired < size_) pair_from(paired, touched, before);
    for (int j = 0; j < size_; ++j) nth(slots_, j).set_contact(touched[j]);
  }

  /// The memory of contact j of this cycle.
  Memory& operator[](int j) { return nth(slots_, std::min(j, Capacity - 1)).memory; }

  /// Forgets all contacts.
  void clear() { size_ = 0; }

 private:
  static constexpr int max_dimension = 3;      // as of a mechanism's task
  static constexpr double min_cosine = 0.866;  // between a contact's normal and that of another wall's memory
  static constexpr double same_cosine = 0.999;  // between the normals of one face in two cycles
  static constexpr double unlike = -1;          // similarity of a contact that cannot continue a memory

  struct slot {
    int wall = 0;
    std::array<float, max_dimension> normal = {};  // exact enough to compare
    Memory memory = {};

    template <class Contact>
    void set_contact(const Contact& c) {
      wall = c.wall_number;
      for (int i = 0; i < int(c.normal.size()); ++i) nth(normal, i) = float(c.normal[i]);
    }
    template <class Contact>
    double cosine(const Contact& c) const {
      double sum = 0;
      for (int i = 0; i < int(c.normal.size()); ++i) sum += c.normal[i] * double(nth(normal, i));
      return sum;
    }
    template <class Contact>
    bool is_of(const Contact& c) const {
      return c.wall_number == wall && cosine(c) > same_cosine;
    }
    template <class Contact>
    double similarity(const Contact& c) const {
      const double of_normals = cosine(c);
      if (c.wall_number == wall) return of_normals + 1 - min_cosine;
      return of_normals > min_cosine ? of_normals : unlike;
    }
  };

  static unsigned all_between(int first, int end) { return (1u << end) - (1u << first); }
  static bool holds(unsigned set, int k) { return (set >> k & 1u) != 0; }

  // Brings the memory of each contact from the `first` on to its place
  template <class Contacts>
  [[gnu::noinline]] void pair_from(int first, const Contacts& touched, int before) {
    unsigned open = all_between(first, size_), known = all_between(first, before);  // those without a partner
    for (;;) {
      double most = unlike;
      int contact = 0, memory = 0;
      for (int j = first; j < size_; ++j) {
        for (int k = first; k < before; ++k) {
          if (!holds(open, j) || !holds(known, k)) continue;
          const double similarity = nth(slots_, k).similarity(touched[j]);
          if (!(similarity > most)) continue;
          most = similarity;
          contact = j;
          memory = k;
        }
      }
      if (most == unlike) break;
      std::swap(nth(slots_, contact), nth(slots_, memory));
      open &= ~(1u << contact);
      known &= ~(1u << (holds(known, contact) ? contact : memory));  // what was there is at `memory` now
    }
    for (int j = first; j < size_; ++j)
      if (holds(open, j)) nth(slots_, j).memory = {};
  }

  std::array<slot, static_cast<std::size_t>(Capacity)> slots_{};
  int size_ = 0;  // contacts of this cycle
};

}  // namespace passive_haptics
