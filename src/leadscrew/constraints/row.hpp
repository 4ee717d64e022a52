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

#include <leadscrew/geometry/point.hpp>
#include <leadscrew/numeric/pair.hpp>
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

/// A place on a path: what limits are asked at. Of a number, or of two places side by side: T is double or numeric::Pair,
/// here and in all that follows.
template <typename T>
struct PlaceOf {
  const geometry::PointJetOf<T>& jet;  ///< axis positions and derivatives by path length, mm or degrees
  T feed{};                            ///< greatest speed by the programmed feed, units of path length per second; > 0
  Chords chords{};
};
using Place = PlaceOf<double>;

/// How the path is travelled at one instant: ṡ, s̈, s⃛, units of path length and seconds.
template <typename T>
struct PathRatesOf {
  T speed{}, acceleration{}, jerk{};
};
using PathRates = PathRatesOf<double>;

template <typename T>
struct SpeedRowOf {
  T rate{}, limit{};

  /// Value over limit.
  T ratio(const PathRatesOf<T>& at) const { return numeric::magnitude(rate * at.speed) / limit; }
};
using SpeedRow = SpeedRowOf<double>;

template <typename T>
struct SquareRowOf {
  T greatest{};

  T ratio(const PathRatesOf<T>& at) const { return numeric::magnitude(at.speed) / numeric::root(greatest); }
};
using SquareRow = SquareRowOf<double>;

template <typename T>
struct AccelerationRowOf {
  T by_x{}, by_b{}, limit = numeric::all<T>(std::numeric_limits<double>::infinity());

  bool bounds() const { return by_x != 0 || by_b != 0; }
  T ratio(const PathRatesOf<T>& at) const {
    return numeric::magnitude(by_x * at.speed * at.speed + by_b * at.acceleration) / limit;
  }
};
using AccelerationRow = AccelerationRowOf<double>;

template <typename T>
struct JerkRowOf {
  T by_x{}, by_b{}, by_c{}, limit = numeric::all<T>(std::numeric_limits<double>::infinity());

  bool bounds() const { return by_x != 0 || by_b != 0 || by_c != 0; }
  T ratio(const PathRatesOf<T>& at) const {
    const T v = at.speed;
    return numeric::magnitude(by_x * v * v * v + by_b * v * at.acceleration + by_c * at.jerk) / limit;
  }
};
using JerkRow = JerkRowOf<double>;

}  // namespace leadscrew::constraints
