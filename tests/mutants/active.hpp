// What the switches of a mutated copy of include/ ask: the environment says which mutant is on. Each one that
// is reached leaves a mark in a file that all processes of a test share, those that die as well.
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <type_traits>

namespace passive_haptics_mutants {

inline constexpr int capacity = 1 << 14;

inline unsigned char* shared_marks() {
  static unsigned char none[capacity];
  const char* path = std::getenv("PASSIVE_HAPTICS_MUTANTS_REACHED");
  const int file = path ? ::open(path, O_RDWR) : -1;
  if (file < 0) return none;
  void* marks = ::mmap(nullptr, capacity, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  ::close(file);
  return marks == MAP_FAILED ? none : static_cast<unsigned char*>(marks);
}

inline int chosen_mutant() {
  const char* number = std::getenv("PASSIVE_HAPTICS_MUTANT");
  return number ? std::atoi(number) : -1;
}

inline unsigned char* const marks = shared_marks();
inline const int chosen = chosen_mutant();

inline bool active(int number) noexcept {
  __atomic_store_n(marks + number, 1, __ATOMIC_RELAXED);  // by any thread
  return number == chosen;
}

// What an expression is once it is evaluated: a matrix of Eigen, or itself.
template <class T>
struct evaluated {
  using type = T;
};
template <class T>
  requires requires { typename T::PlainObject; }
struct evaluated<T> {
  using type = typename T::PlainObject;
};

template <class A, class B>
[[gnu::always_inline]] inline auto either(bool first, const A& a, const B& b) -> typename evaluated<B>::type {
  using value = typename evaluated<B>::type;
  return first ? value(a) : value(b);
}

template <class T>
[[gnu::always_inline]] inline auto value_of(const T& x) -> typename evaluated<T>::type {
  return x;
}

// Of a and b, functions without arguments, only one is called.
template <class A, class B>
[[gnu::always_inline]] inline auto either_of(bool first, const A& a, const B& b) -> decltype(b()) {
  return first ? decltype(b())(a()) : b();
}

}  // namespace passive_haptics_mutants
