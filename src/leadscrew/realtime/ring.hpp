#pragma once
// A ring that one thread fills and another empties, without a lock. It holds no pointers: it may lie in memory that two
// processes share.

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace leadscrew::realtime {

/// Of `capacity` values. Whoever reads sees a value only when all of it has been written: its number is released by the
/// store of `written_`, and its place is free again when `read_` has passed it.
template <class Value, std::size_t capacity>
class Ring {
  static_assert(std::is_trivially_copyable_v<Value> && std::atomic<std::uint64_t>::is_always_lock_free);

 public:
  /// The writer's. False if the ring is full.
  bool push(const Value& value) noexcept {
    const std::uint64_t number = written_.load(std::memory_order_relaxed);
    if (number - read_.load(std::memory_order_acquire) >= capacity) return false;
    values_[number % capacity] = value;
    written_.store(number + 1, std::memory_order_release);
    return true;
  }

  /// The reader's. False if the ring is empty.
  bool pop(Value& value) noexcept {
    const std::uint64_t number = read_.load(std::memory_order_relaxed);
    if (number == written_.load(std::memory_order_acquire)) return false;
    value = values_[number % capacity];
    read_.store(number + 1, std::memory_order_release);
    return true;
  }

  /// How many wait. Anybody's.
  std::size_t size() const noexcept {
    const std::uint64_t read = read_.load(std::memory_order_acquire);
    const std::uint64_t waiting = written_.load(std::memory_order_acquire) - read;
    return static_cast<std::size_t>(std::min<std::uint64_t>(waiting, capacity));
  }

 private:
  static constexpr std::size_t cache_line = 64;

  alignas(cache_line) std::atomic<std::uint64_t> written_{0};
  alignas(cache_line) std::atomic<std::uint64_t> read_{0};
  alignas(cache_line) std::array<Value, capacity> values_{};
};

}  // namespace leadscrew::realtime
