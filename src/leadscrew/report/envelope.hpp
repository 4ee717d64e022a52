#pragma once
// Extremes of many channels over equal bins of samples, in bounded memory: when the bins run out, neighbours become
// one.

#include <array>
#include <cstddef>
#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/report/recording.hpp>
#include <span>
#include <vector>

namespace leadscrew::report {

class Envelope {
 public:
  static constexpr std::size_t most_bins = 4096;
  static constexpr std::size_t most_channels = 1 + 4 * base::axis_count;

  explicit Envelope(std::size_t channels);

  /// The values of the next sample.
  double* sample() { return sample_.data(); }
  /// Takes what stands in sample().
  void take();

  std::int64_t samples() const { return samples_; }
  std::int64_t samples_per_bin() const { return samples_per_bin_; }
  std::span<const Extent> channel(std::size_t channel);

 private:
  void store_bin();
  void merge_neighbours();

  std::size_t channels_;
  std::array<double, most_channels> sample_{};
  std::array<double, most_channels> least_{};
  std::array<double, most_channels> greatest_{};
  std::vector<std::vector<Extent>> extents_;  ///< of each channel; room for most_bins
  std::size_t bins_ = 0;                      ///< that are full
  std::int64_t in_bin_ = 0;                   ///< samples of the bin that fills
  std::int64_t samples_per_bin_ = 1;
  std::int64_t samples_ = 0;
};

}  // namespace leadscrew::report
