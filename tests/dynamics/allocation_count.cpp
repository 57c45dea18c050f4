// SPDX-License-Identifier: Apache-2.0
// Eigen calls malloc or posix_memalign, the standard library operator new; the linker leads the
// former here (--wrap), the language the latter.
#include "tests/dynamics/allocation_count.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<long> allocations = 0;
}

extern "C" {
void* __real_malloc(std::size_t bytes);
void* __real_calloc(std::size_t count, std::size_t bytes);
void* __real_realloc(void* memory, std::size_t bytes);
int __real_posix_memalign(void** memory, std::size_t alignment, std::size_t bytes);
void* __wrap_malloc(std::size_t bytes) { return ++allocations, __real_malloc(bytes); }
void* __wrap_calloc(std::size_t count, std::size_t bytes) {
  return ++allocations, __real_calloc(count, bytes);
}
void* __wrap_realloc(void* memory, std::size_t bytes) {
  return ++allocations, __real_realloc(memory, bytes);
}
int __wrap_posix_memalign(void** memory, std::size_t alignment, std::size_t bytes) {
  return ++allocations, __real_posix_memalign(memory, alignment, bytes);
}
}

void* operator new(std::size_t bytes) {
  ++allocations;
  void* memory = __real_malloc(bytes == 0 ? 1 : bytes);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace torquewright::test {
long allocation_count() { return allocations; }
}  // namespace torquewright::test
