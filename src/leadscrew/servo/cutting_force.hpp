#pragma once
// The force on a milling cutter, tooth by tooth.
//
//        ╭───╮ n           A tooth at the angle φ takes a chip of the thickness h = fz·sin φ while 0 < φ < φe,
//   ─────┤   ├─────  ╮
//   work │   │       ├ ae     F = ap·Σ (Kt·fz·sin φ + Ke)  over the teeth that cut,   fz = feed/(n·z)
//        ╰───╯       ╯
//      ──▶ feed            cos φe = 1 − 2·ae/D.
//
// Kt and Ke are the cutting and the edge coefficient of the linear model of milling (Y. Altintas, "Manufacturing
// Automation"). The mean over a turn is closed,
//
//   F̄ = z·ap/2π·(Kt·fz·(1 − cos φe) + Ke·φe),
//
// so that without edges force times cutting speed is Kt times the volume that is cut in a second.
//
// Noise is drawn from a seed: the same seed gives the same forces.

#include <cstdint>
#include <leadscrew/base/result.hpp>

namespace leadscrew::servo {

struct MillingOptions {
  int teeth = 4;                   ///< z; 1 … 64
  double diameter = 10;            ///< D, mm; > 0
  double spindle_speed = 50;       ///< n, revolutions a second; > 0
  double cutting_coefficient = 0;  ///< Kt, N/mm²; > 0
  double edge_coefficient = 0;     ///< Ke, N/mm; ≥ 0
  double noise = 0;                ///< its standard deviation, N; ≥ 0. It stays within √6 of it
  std::uint64_t seed = 1;
};

/// How the cutter stands in the work.
struct Engagement {
  double depth = 0;  ///< ap, mm, along the axis of the cutter; ≥ 0
  double width = 0;  ///< ae, mm; 0 … D
};

class MillingForce {
 public:
  /// Code: `servo-milling`.
  static base::Result<MillingForce> create(const MillingOptions& options);

  /// Turns the cutter for so many seconds, and then the force, N, with noise. feed: mm/s; ≥ 0.
  double after(double seconds, double feed, const Engagement& engagement);

  /// Of a turn, N, without noise.
  double mean(double feed, const Engagement& engagement) const;

 private:
  explicit MillingForce(const MillingOptions& options) : options_(options), random_(options.seed) {}
  double engaged_angle(double width) const;
  double noise();

  MillingOptions options_;
  std::uint64_t random_;
  double turns_ = 0;  // of the cutter since a first tooth came in, 0 … 1
};

}  // namespace leadscrew::servo
