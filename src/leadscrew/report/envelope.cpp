#include <leadscrew/report/envelope.hpp>

#include <algorithm>

namespace leadscrew::report {

Envelope::Envelope(std::size_t channels) : channels_(channels), extents_(channels, std::vector<Extent>(most_bins)) {}

void Envelope::take() {
  if (in_bin_ == 0) {
    least_ = sample_;
    greatest_ = sample_;
  } else {
    for (std::size_t c = 0; c < channels_; ++c) {
      least_[c] = std::min(least_[c], sample_[c]);
      greatest_[c] = std::max(greatest_[c], sample_[c]);
    }
  }
  ++samples_;
  if (++in_bin_ < samples_per_bin_) return;
  store_bin();
  ++bins_;
  in_bin_ = 0;
  if (bins_ == most_bins) merge_neighbours();
}

void Envelope::store_bin() {
  for (std::size_t c = 0; c < channels_; ++c) extents_[c][bins_] = {least_[c], greatest_[c]};
}

void Envelope::merge_neighbours() {
  for (std::vector<Extent>& extents : extents_) {
    for (std::size_t i = 0; i < bins_ / 2; ++i) {
      const Extent a = extents[2 * i], b = extents[2 * i + 1];
      extents[i] = {std::min(a.least, b.least), std::max(a.greatest, b.greatest)};
    }
  }
  bins_ /= 2;
  samples_per_bin_ *= 2;
}

std::span<const Extent> Envelope::channel(std::size_t channel) {
  if (in_bin_ > 0) store_bin();
  return std::span<const Extent>(extents_[channel]).first(bins_ + (in_bin_ > 0 ? 1 : 0));
}

}  // namespace leadscrew::report
