// Counts what a thread allocates and frees. Before any other header, and in one file of a program: it
// replaces operator new.
#pragma once
#undef NDEBUG  // so that Eigen's own check runs in any build
#define EIGEN_RUNTIME_NO_MALLOC

#include <Eigen/Core>

#include <cstddef>
#include <cstdlib>
#include <new>

namespace {
thread_local long allocations = 0;  // and frees

void* allocate(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size == 0 ? 1 : size)) return p;
  throw std::bad_alloc();
}

void release(void* p) {
  if (p != nullptr) ++allocations;
  std::free(p);
}
}  // namespace

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void operator delete(void* p) noexcept { release(p); }
void operator delete[](void* p) noexcept { release(p); }
void operator delete(void* p, std::size_t) noexcept { release(p); }
void operator delete[](void* p, std::size_t) noexcept { release(p); }

namespace {

// Calls of operator new and delete in f; Eigen ends the program if it reaches for malloc there.
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
