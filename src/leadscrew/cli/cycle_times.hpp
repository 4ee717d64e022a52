#pragma once
// How long the cycles took, in memory that does not grow with their number: a histogram whose buckets are 1/32 of a
// power of two wide, so that a percentile is right within 3.2 %.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace leadscrew::cli {

class CycleTimes {
 public:
  /// One cycle, in nanoseconds.
  void observe(std::int64_t nanoseconds) {
    const auto value = static_cast<std::uint64_t>(std::max<std::int64_t>(nanoseconds, 0));
    ++buckets_[bucket_of(value)];
    ++count_;
    longest_ = std::max(longest_, value);
  }

  /// The least time that at least this part (0 … 1) of the cycles did not exceed, rounded up to its bucket's end; 0
  /// without cycles.
  std::uint64_t percentile(double part) const {
    const double wanted = part * static_cast<double>(count_);
    std::uint64_t seen = 0;
    for (std::size_t bucket = 0; bucket < buckets_.size(); ++bucket) {
      seen += buckets_[bucket];
      if (seen > 0 && static_cast<double>(seen) >= wanted) return std::min(last_of(bucket), longest_);
    }
    return longest_;
  }

  std::uint64_t longest() const { return longest_; }

 private:
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

  std::array<std::uint64_t, (64 - fine_bits + 1) * fine> buckets_{};
  std::uint64_t count_ = 0;
  std::uint64_t longest_ = 0;
};

}  // namespace leadscrew::cli
