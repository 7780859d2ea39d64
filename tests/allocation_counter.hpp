#pragma once
// Counts allocations: include it in a *_alloc_test.cpp, it replaces the global operator new. The definitions
// are weak, so that several test files of one binary may include it; all share one counter.

#include <cstdint>
#include <cstdlib>
#include <new>

namespace kerf {

inline thread_local std::uint64_t allocation_count = 0;

}  // namespace kerf

__attribute__((weak)) void* operator new(std::size_t size) {
  ++kerf::allocation_count;
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
__attribute__((weak)) void* operator new[](std::size_t size) {
  return operator new(size);
}
__attribute__((weak)) void operator delete(void* memory) noexcept {
  std::free(memory);
}
__attribute__((weak)) void operator delete[](void* memory) noexcept {
  std::free(memory);
}
__attribute__((weak)) void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
__attribute__((weak)) void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}
