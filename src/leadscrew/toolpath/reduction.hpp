#pragma once
// Fewer legs that say the same: lines that run straight on are one, and so is what happens within a small part of the
// tolerance.

#include <leadscrew/toolpath/feed_length.hpp>
#include <leadscrew/toolpath/path.hpp>
#include <optional>
#include <vector>

namespace leadscrew::toolpath {

/// What one move asks for, or several that were made one.
struct Leg {
  geometry::Curve curve;
  double feed = 0;  ///< as a Piece's
  base::Line line{};
  std::vector<LineMark> lines{};        ///< of the moves behind the first, by path length
  double spent = 0;                     ///< how far the moves may be from the curve, mm
  FeedAxes feed_axes = FeedAxes::none;  ///< as a Piece's
};

inline bool is_line(const geometry::Curve& curve) {
  return std::holds_alternative<geometry::Line>(curve);
}

/// By which its feed is counted.
inline FeedAxes axes_of(const Leg& leg) {
  return feed_axes(geometry::moving(leg.curve));
}

/// Millimetres of the space of tolerances (tolerance_space.hpp) per unit of the curve's length, at its start.
double millimetres_per_length(const geometry::Curve& curve);

class Reduction {
 public:
  explicit Reduction(double tolerance) : tolerance_(tolerance) {}

  /// Returns what is no longer to grow.
  std::optional<Leg> push(Leg leg);
  std::optional<Leg> finish();

 private:
  bool join(const Leg& leg);

  double tolerance_;
  std::optional<Leg> open_;
  geometry::Point start_{}, end_{};  ///< of the open leg, mm
  double seconds_ = 0;               ///< that feed lets its legs take, one by one
  double radius_ = 0;                ///< of the ball about its start in which all its inner vertices lie
};

}  // namespace leadscrew::toolpath
