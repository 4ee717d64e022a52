#pragma once
// The shapes that a limit can have at one place of a path. With x = ṡ², b = s̈ and c such that s⃛ = c√x (Bobrow et al.,
// 1985; Pham & Pham, 2018), every coordinate q of the path has
//
//     q̇ = q′√x          q̈ = q″x + q′b          q⃛ = (q‴x + 3q″b + q′c)√x
//
// and every limit is a row of one of these shapes:
//
//     SpeedRow          |rate|·√x ≤ limit
//     SquareRow         x ≤ greatest
//     AccelerationRow   |by_x·x + by_b·b| ≤ limit
//     JerkRow           |by_x·x + by_b·b + by_c·c|·√x ≤ limit
//
// limit and greatest are > 0 and may be infinite; a row whose coefficients are all 0 bounds nothing there.

#include <cmath>
#include <leadscrew/geometry/point.hpp>
#include <limits>
#include <optional>

namespace leadscrew::constraints {

/// Of chords between words.
struct Chords {
  double sagitta = 0;  ///< that the tolerance leaves for them, mm; ≥ 0
  /// How much the tool tip's path bends against them, 1/mm, ≥ 0; none: the axes are the tip's coordinates, and their
  /// curvature is meant.
  std::optional<double> bend{};
};

/// A place on a path: what limits are asked at.
struct Place {
  const geometry::PointJet& jet;  ///< axis positions and derivatives by path length, mm or degrees
  double feed = 0;                ///< greatest speed by the programmed feed, units of path length per second; > 0
  Chords chords{};
};

/// How the path is travelled at one instant: ṡ, s̈, s⃛, units of path length and seconds.
struct PathRates {
  double speed = 0, acceleration = 0, jerk = 0;
};

struct SpeedRow {
  double rate = 0, limit = 0;

  /// Value over limit.
  double ratio(const PathRates& at) const { return std::abs(rate * at.speed) / limit; }
};

struct SquareRow {
  double greatest = 0;

  double ratio(const PathRates& at) const { return std::abs(at.speed) / std::sqrt(greatest); }
};

struct AccelerationRow {
  double by_x = 0, by_b = 0, limit = std::numeric_limits<double>::infinity();

  bool bounds() const { return by_x != 0 || by_b != 0; }
  double ratio(const PathRates& at) const {
    return std::abs(by_x * at.speed * at.speed + by_b * at.acceleration) / limit;
  }
};

struct JerkRow {
  double by_x = 0, by_b = 0, by_c = 0, limit = std::numeric_limits<double>::infinity();

  bool bounds() const { return by_x != 0 || by_b != 0 || by_c != 0; }
  double ratio(const PathRates& at) const {
    const double v = at.speed;
    return std::abs(by_x * v * v * v + by_b * v * at.acceleration + by_c * at.jerk) / limit;
  }
};

}  // namespace leadscrew::constraints
