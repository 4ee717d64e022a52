#pragma once
// The latest of many values, from one thread to another, without a lock: neither waits for the other, whatever the
// other does.

#include <array>
#include <atomic>
#include <cstddef>
#include <type_traits>

namespace leadscrew::realtime {

/// Three places: one that is written, one that is read, and the latest whole value between them. Putting and taking
/// exchange theirs for that one.
template <class Value>
class Latest {
  static_assert(std::is_trivially_copyable_v<Value> && std::atomic<unsigned>::is_always_lock_free);

 public:
  /// The writer's.
  void put(const Value& value) noexcept {
    places_[written_].value = value;
    written_ = between_.exchange(written_ | fresh, std::memory_order_acq_rel) & ~fresh;
  }

  /// The reader's. False, and nothing is changed, if no value has been put since the last one was taken.
  bool take(Value& value) noexcept {
    if ((between_.load(std::memory_order_relaxed) & fresh) == 0) return false;
    read_ = between_.exchange(read_, std::memory_order_acq_rel) & ~fresh;
    value = places_[read_].value;
    return true;
  }

 private:
  static constexpr unsigned fresh = 4;
  static constexpr std::size_t cache_line = 64;

  struct alignas(cache_line) Place {
    Value value;
  };

  std::array<Place, 3> places_{};
  alignas(cache_line) unsigned written_ = 0;
  alignas(cache_line) std::atomic<unsigned> between_{1};
  alignas(cache_line) unsigned read_ = 2;
};

}  // namespace leadscrew::realtime
