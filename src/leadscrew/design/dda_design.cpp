#include <algorithm>
#include <cmath>
#include <leadscrew/design/dda_design.hpp>
#include <leadscrew/numeric/rounded_up.hpp>

namespace leadscrew::design {

namespace {

/// The fewest bits that hold the value.
int bits_for(std::int64_t value) {
  int bits = 1;
  while ((std::int64_t{1} << bits) - 1 < value) ++bits;
  return bits;
}

}  // namespace

DdaDesign design_dda(const DdaRange& range) {
  DdaDesign design;
  design.axis_bits = bits_for(numeric::rounded_up(range.travel_mm / range.blu_mm));
  design.feed_word_max = numeric::rounded_up(10 * range.max_feed_mm_min / range.min_distance_mm);
  design.feed_bits = bits_for(design.feed_word_max);
  design.clock_pps = std::ldexp(1.0, design.axis_bits + design.feed_bits) / 10 / numeric::seconds_per_minute;
  return design;
}

DdaLine along_line(const DdaDesign& design, const DdaRange& range, const std::vector<double>& delta_mm,
                   double feed_mm_min, bool word_rounded) {
  DdaLine line;
  double square = 0;
  for (const double delta : delta_mm) {
    line.pulses.push_back(std::llround(delta / range.blu_mm));
    square += static_cast<double>(line.pulses.back()) * static_cast<double>(line.pulses.back());
  }
  const double length = std::sqrt(square);
  line.feed_word = 10 * feed_mm_min / range.blu_mm / length;
  if (word_rounded) line.feed_word = std::max(1.0, std::round(line.feed_word));
  line.feed_pps = design.clock_pps * line.feed_word / std::ldexp(1.0, design.feed_bits);
  for (const std::int64_t pulses : line.pulses) {
    const double distance = std::abs(static_cast<double>(pulses));
    line.axis_pps.push_back(line.feed_pps * distance / std::ldexp(1.0, design.axis_bits));
  }
  line.feed_mm_min = line.feed_word * length * range.blu_mm / 10;
  line.seconds = std::ldexp(1.0, design.axis_bits) / line.feed_pps;
  return line;
}

DdaTimer design_timer(double clock_pps, const std::vector<double>& delays) {
  DdaTimer timer;
  double longest = 0;
  for (const double delay : delays) longest = std::max(longest, delay * clock_pps);
  timer.bits = std::max(1, static_cast<int>(std::ceil(std::log2(longest * (1 - numeric::quotient_rounding)))));
  const double capacity = std::ldexp(1.0, timer.bits);
  for (const double delay : delays) {
    timer.loads.push_back(std::max<std::int64_t>(1, std::llround(capacity / (delay * clock_pps))));
    timer.seconds.push_back(std::ceil(capacity / static_cast<double>(timer.loads.back())) / clock_pps);
  }
  return timer;
}

}  // namespace leadscrew::design
