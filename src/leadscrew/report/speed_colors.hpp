#pragma once
// A colour for each speed: hue from violet over teal to yellow while lightness rises evenly, so that it reads without
// colour vision and in grey print. Two ramps, one that stands out on white, one on black.
//
// Colours are computed in OKLCH (B. Ottosson, "A perceptual color space for image processing", 2020).

#include <cstddef>
#include <leadscrew/report/recording.hpp>
#include <span>
#include <string>

namespace leadscrew::report {

inline constexpr std::size_t speed_levels = 24;

enum class Background { light, dark, either };

/// "#rrggbb" of a level in [0, speed_levels).
std::string speed_color(std::size_t level, Background background);

/// From the speed of feed moves to the place on the ramp, 0 … 1; rapids have no part in it. Where most of the path is much
/// slower than its fastest part, the square root of the speed is shown instead of the speed, so that differences among
/// slow parts can be seen.
struct SpeedScale {
  double greatest = 0;  ///< mm/s
  bool square_root = false;

  double place(double feed) const;
  std::size_t level(double feed) const;
};

/// greatest: speed of all feed moves, mm/s.
SpeedScale speed_scale(std::span<const PathPoint> path, double greatest);

}  // namespace leadscrew::report
