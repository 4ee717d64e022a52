#pragma once
// Straight through poles: where a path of directions passes a pole so near that the tool may be held as far off, it is led
// through the pole itself, and the first axis need not turn.
//
//            ·  · O programmed ·  ·          m  the miss, angle from the pole at the nearest place s₀
//     ──────·──┐ ┌───────────────·──────     w  (1 − x²)⁴, x = (s − s₀)/H
//               ╲│╱ m
//     ───────────●────────────────────       O turned by m·w about the axis that leads O(s₀) to the pole
//               pole   travelled
//
// The path is turned over a length H on either side, and nowhere by more than m: the tool leaves its programmed direction by
// no more. Angles stay smooth: across the path there is m(1 − w) = m x²(4 − 6x² + …) of what along it is in proportion to x.
//
// Where a path wanders about the pole inside the cone, it is held at the pole from the first place that is nearest to the last,
// so that the first axis turns evenly in between.
//
// s is path length in mm by which a radian of the tool's direction counts as 50 mm.

#include <cstddef>
#include <deque>
#include <leadscrew/kinematics/chain.hpp>
#include <leadscrew/kinematics/great_circle.hpp>
#include <limits>
#include <optional>
#include <vector>

namespace leadscrew::kinematics {

/// From one programmed direction to the next.
struct DirectionSegment {
  GreatCircle circle;
  double from = 0, to = 0;  ///< s; from ≤ to

  double share_at(double s) const { return to > from ? (s - from) / (to - from) : 1; }
  Vector at(double s) const { return circle.at(share_at(s)); }
};

/// One pass through a pole, or a stay there.
struct PolePass {
  Vector pole{};                         ///< a unit vector
  double first = 0, last = 0;            ///< s: from here to there the tool is held at the pole
  double entry = 0, exit = 0;            ///< H before and behind, > 0
  double entry_miss = 0, exit_miss = 0;  ///< m, radians
  Vector entry_axis{}, exit_axis{};      ///< of the turns that lead O to the pole
  double greatest = 0;                   ///< by so much the tool leaves its direction, radians

  double begin() const { return first - entry; }
  double end() const { return last + exit; }
  bool is_held(double s) const;
  /// The direction travelled in place of a programmed one.
  Vector applied(double s, const Vector& direction) const;
};

/// Finds passes along a path that is told segment by segment.
class PolePasses {
 public:
  static constexpr double shortest_reach = 16, longest_reach = 50;  ///< H, mm
  static constexpr double radius = 50;                              ///< mm a radian, of s

  /// The cone is in radians; no passes at 0.
  PolePasses(const Chain& chain, double cone);

  /// The next segment; it begins where the one before ended.
  void observe(const DirectionSegment& segment);
  /// So far all passes are known that may change the path, mm: those of settled().
  double known_until() const;
  /// No segment follows; or what is open is not waited for, and passes do not reach back before where the path is now.
  void close();

  /// Those that change the path between two places. Known up to known_until(); valid until the next call of another function.
  std::vector<const PolePass*> between(double from, double to) const;
  /// Those that end before are not asked for again.
  void forget_before(double s);

 private:
  struct Place {
    double s = 0;
    Vector direction{};
    double rate = 0;  ///< of the direction there, radians per mm
  };
  struct Stretch {
    Vector pole{};
    double begin = 0;
    bool is_from_start = false;
    std::optional<Place> first, last;  ///< nearest places: the first and the last that there are
  };

  std::optional<Vector> pole_near(const Vector& direction) const;
  void extend(const DirectionSegment& segment, const Vector& pole);
  void end_stretch(bool at_end);
  PolePass pass_of(const Stretch& stretch) const;
  void settle(bool all);

  std::vector<Vector> poles_;  ///< that there are
  double cone_, cone_sine_;
  double floor_ = 0;  ///< passes reach back no farther
  double end_ = 0;    ///< s
  bool is_at_start_ = true;
  std::optional<Stretch> open_;
  std::deque<PolePass> found_;  ///< that the next one may shorten
  std::deque<PolePass> settled_;
};

}  // namespace leadscrew::kinematics
