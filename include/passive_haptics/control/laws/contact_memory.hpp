/// Memory of a law for each contact.
#pragma once

#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/scene/contacts.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace passive_haptics {

/// Memories of up to Capacity simultaneous contacts. The law must define this Capacity as `max_contacts`.
///
/// **Continued contacts.** A wall number does not identify a contact: the faces of a mesh share one, and at
/// the seam of two walls the hand slides on while the number changes. A memory therefore belongs to a wall
/// and a normal. Each cycle pairs its contacts with the previous memories, the most similar normals first. A
/// contact continues a memory of its own wall for any rotation of the normal, and of another wall if the
/// normals differ by less than 30 degrees, so that a learned force stays correct to 13 %. The same wall
/// counts as much as these 30 degrees. A contact without a partner gets a new memory; a memory without a
/// partner is dropped.
template <class Memory, int Capacity>
class contact_memory {
 public:
  static constexpr int capacity = Capacity;  ///< Maximum number of contacts.

  /// Call at the beginning of a cycle, with its contacts. Contacts beyond Capacity share a memory.
  template <class Contacts>
  void begin_cycle(const Contacts& touched) {
    const int before = size_;
    size_ = std::min(touched.size(), Capacity);
    int paired = 0;  // unchanged contacts, usually all
    while (paired < std::min(size_, before) && nth(slots_, paired).is_of(touched[paired])) ++paired;
    if (paired < size_) pair_from(paired, touched, before);
    for (int j = 0; j < size_; ++j) nth(slots_, j).set_contact(touched[j]);
  }

  /// Memory of contact j in this cycle.
  Memory& operator[](int j) { return nth(slots_, std::min(j, Capacity - 1)).memory; }

  void clear() { size_ = 0; }  ///< Forgets all contacts.

 private:
  static constexpr int max_dimension = 3;       // of a mechanism's task
  static constexpr double min_cosine = 0.866;   // between the normals of a contact and another wall's memory
  static constexpr double same_cosine = 0.999;  // between the normals of one face in two cycles
  static constexpr double unlike = -1;          // similarity of a contact that cannot continue a memory

  struct slot {
    int wall = 0;
    std::array<float, max_dimension> normal = {};  // precise enough for comparisons
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

  // Moves the memory of each contact from `first` on to its place
  template <class Contacts>
  [[gnu::noinline]] void pair_from(int first, const Contacts& touched, int before) {
    unsigned open = all_between(first, size_), known = all_between(first, before);  // without a partner
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
      known &= ~(1u << (holds(known, contact) ? contact : memory));  // the previous entry is now at `memory`
    }
    for (int j = first; j < size_; ++j)
      if (holds(open, j)) nth(slots_, j).memory = {};
  }

  std::array<slot, static_cast<std::size_t>(Capacity)> slots_{};
  int size_ = 0;  // contacts of this cycle
};

}  // namespace passive_haptics
