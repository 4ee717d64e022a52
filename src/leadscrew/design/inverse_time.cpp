#include <cmath>
#include <leadscrew/design/inverse_time.hpp>
#include <leadscrew/numeric/rounded_up.hpp>

namespace leadscrew::design {

InverseTimeDesign design_inverse_time(const InverseTimeRange& range) {
  InverseTimeDesign design;
  design.capacity = numeric::rounded_up(range.max_distance / range.blu);
  design.feed_capacity = 1;
  for (int digit = 0; digit < range.digits; ++digit) design.feed_capacity *= 10;
  design.clock_pps = static_cast<double>(design.capacity) * static_cast<double>(design.feed_capacity) / 600;
  design.software_feed_capacity = numeric::rounded_up(range.max_feed / range.resolution);
  // At f = q₀ there is a command at every interrupt.
  design.software_clock_pps =
      static_cast<double>(design.software_feed_capacity) * range.resolution / range.blu / numeric::seconds_per_minute;
  return design;
}

FeedWord inverse_time_word(const InverseTimeRange& range, double distance, double feed, bool rounded) {
  FeedWord word;
  word.word = 10 * feed / distance;
  if (rounded) word.word = std::round(word.word);
  word.feed = word.word * distance / 10;
  word.feed_pps = word.feed / range.blu / numeric::seconds_per_minute;
  return word;
}

FeedWord software_word(const InverseTimeRange& range, double feed, bool rounded) {
  const InverseTimeDesign design = design_inverse_time(range);
  FeedWord word;
  word.word = feed / range.resolution;
  if (rounded) word.word = std::round(word.word);
  word.feed_pps = design.software_clock_pps * word.word / static_cast<double>(design.software_feed_capacity);
  word.feed = word.feed_pps * range.blu * numeric::seconds_per_minute;
  return word;
}

}  // namespace leadscrew::design
