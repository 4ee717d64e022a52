// A translation unit of its own, so that the compiler never sees one half of a pair inlined and the other not.
#include "allocations.hpp"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::int64_t> count{0}, held{0}, most{0};
thread_local std::int64_t count_of_thread = 0;

void* take(void* memory) {
  ++count;
  ++count_of_thread;
  const std::int64_t now = held += static_cast<std::int64_t>(malloc_usable_size(memory));
  for (std::int64_t before = most; before < now && !most.compare_exchange_weak(before, now);) {
  }
  return memory;
}

void give_back(void* memory) {
  if (memory == nullptr) return;
  held -= static_cast<std::int64_t>(malloc_usable_size(memory));
  std::free(memory);
}

}  // namespace

std::int64_t leadscrew::testing_support::allocations() {
  return count;
}
std::int64_t leadscrew::testing_support::allocations_of_thread() {
  return count_of_thread;
}
std::int64_t leadscrew::testing_support::memory_held() {
  return held;
}
std::int64_t leadscrew::testing_support::most_memory_held() {
  return most;
}
void leadscrew::testing_support::watch_memory() {
  most = held.load();
}

// The array and aligned-by-default forms end here as well, but for those of sanitizers, which are pairs of their own.
void* operator new(std::size_t size) {
  if (void* const memory = std::malloc(size > 0 ? size : 1)) return take(memory);
  throw std::bad_alloc();
}
/// As std::stable_sort takes its buffer, which it gives back to the ordinary operator.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  void* const memory = std::malloc(size > 0 ? size : 1);
  return memory != nullptr ? take(memory) : nullptr;
}
void operator delete(void* memory) noexcept {
  give_back(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  give_back(memory);
}
