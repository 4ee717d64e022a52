#pragma once
// How long something took, again and again, in memory that does not grow: a histogram whose buckets are 1/32 of a power
// of two wide, so that a percentile is right within 3.2 %. One thread observes, any other may look: what it sees lies
// between two observations or is one short in a bucket.

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <vector>

namespace leadscrew::realtime {

/// How long things took. One thread observes, any other reads.
class Histogram {
 public:
  Histogram() = default;
  /// What it holds now.
  Histogram(const Histogram& other) { *this = other; }
  /// The same.
  Histogram& operator=(const Histogram& other) {
    if (this == &other) return *this;
    for (std::size_t bucket = 0; bucket < buckets_.size(); ++bucket) set(buckets_[bucket], other.buckets_[bucket]);
    set(count_, other.count_);
    set(longest_, other.longest_);
    return *this;
  }

  /// One time, in nanoseconds. Neither allocates nor locks.
  void observe(std::int64_t nanoseconds) {
    const auto value = static_cast<std::uint64_t>(std::max<std::int64_t>(nanoseconds, 0));
    set(buckets_[bucket_of(value)], get(buckets_[bucket_of(value)]) + 1);
    set(count_, get(count_) + 1);
    if (value > get(longest_)) set(longest_, value);
  }

  /// The least time that at least this part (0 … 1) of the times did not exceed, rounded up to its bucket's end; 0
  /// without any.
  std::uint64_t percentile(double part) const {
    const double wanted = part * static_cast<double>(get(count_));
    std::uint64_t seen = 0;
    for (std::size_t bucket = 0; bucket < buckets_.size(); ++bucket) {
      seen += get(buckets_[bucket]);
      if (seen > 0 && static_cast<double>(seen) >= wanted) return std::min(last_of(bucket), get(longest_));
    }
    return get(longest_);
  }

  /// Times up to a power of two.
  struct Octave {
    std::uint64_t end = 0;    ///< ns: as long as this or longer is in the next
    std::uint64_t count = 0;  ///< of times from half of it on
  };
  /// By powers of two, from the first to the last that any time lay in; below 32 ns is one.
  std::vector<Octave> octaves() const {
    std::vector<Octave> octaves;
    for (std::size_t first = 0; first < buckets_.size(); first += fine) {
      Octave octave{last_of(first + fine - 1) + 1, 0};
      for (std::size_t bucket = first; bucket < first + fine; ++bucket) octave.count += get(buckets_[bucket]);
      if (!octaves.empty() || octave.count > 0) octaves.push_back(octave);
    }
    while (!octaves.empty() && octaves.back().count == 0) octaves.pop_back();
    return octaves;
  }

  /// Times so far.
  std::uint64_t count() const { return get(count_); }
  /// The longest of them, ns.
  std::uint64_t longest() const { return get(longest_); }

 private:
  using Count = std::atomic<std::uint64_t>;
  static std::uint64_t get(const Count& count) { return count.load(std::memory_order_relaxed); }
  static void set(Count& count, std::uint64_t value) { count.store(value, std::memory_order_relaxed); }

  static constexpr int fine_bits = 5;
  static constexpr std::uint64_t fine = 1u << fine_bits;

  /// Values below 32 have a bucket each; above, the five bits that follow the leading one choose it.
  static constexpr std::size_t bucket_of(std::uint64_t value) {
    if (value < fine) return value;
    const int shift = std::bit_width(value) - 1 - fine_bits;
    return static_cast<std::size_t>(shift + 1) * fine + ((value >> shift) - fine);
  }

  static constexpr std::uint64_t last_of(std::size_t bucket) {
    if (bucket < fine) return bucket;
    const auto shift = bucket / fine - 1;
    return ((bucket % fine + fine + 1) << shift) - 1;
  }

  std::array<Count, (64 - fine_bits + 1) * fine> buckets_{};
  Count count_ = 0;
  Count longest_ = 0;
};

}  // namespace leadscrew::realtime
