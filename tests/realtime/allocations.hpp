// Counts what is allocated. Before any other header, and in one file of a program: it replaces operator new.
#pragma once
#undef NDEBUG  // so that Eigen's own check runs in any build
#define EIGEN_RUNTIME_NO_MALLOC

#include <Eigen/Core>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {
std::atomic<long> allocations = 0;

void* allocate(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size == 0 ? 1 : size)) return p;
  throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }

namespace {

// Calls of operator new in f; Eigen ends the program if it reaches for malloc there.
template <class F>
long allocations_in(F&& f) {
  Eigen::internal::set_is_malloc_allowed(false);
  const long before = allocations;
  f();
  const long after = allocations;
  Eigen::internal::set_is_malloc_allowed(true);
  return after - before;
}

}  // namespace
