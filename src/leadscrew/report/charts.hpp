#pragma once
// Quantities over time, as pictures side by side.

#include <leadscrew/base/sink.hpp>
#include <string>
#include <vector>

namespace leadscrew::report {

/// One quantity from time to time, joined by lines.
struct Curve {
  struct Sample {
    double time = 0;  ///< s, ≥ 0
    double value = 0;
  };
  std::vector<Sample> samples;
  std::size_t color = 0;  ///< its place among curve_colors
};
/// One for each axis there may be.
inline constexpr std::size_t curve_colors = 9;

/// From time 0 on, `interval` seconds apart.
Curve evenly_spaced(const std::vector<double>& values, double interval);

struct Chart {
  std::string title;           ///< what, and under which circumstances
  std::vector<Curve> curves;   ///< the first in front
  std::vector<double> levels;  ///< what they should be, or may be at most: dashed
};

/// A name beside the colour of its curves.
struct ChartKey {
  std::size_t color = 0;
  std::string name;
};

struct ChartSheet {
  std::string title;
  std::vector<Chart> charts;   ///< two a row, time in s across
  std::vector<ChartKey> keys;  ///< below the title, two a row
  bool same_scale = true;      ///< of values, for all charts; of time each has its own
};

base::Result<void> write_charts(const ChartSheet& sheet, const base::ByteSink& sink);

}  // namespace leadscrew::report
