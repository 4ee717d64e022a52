#pragma once
// The path seen from one side, as strokes of an SVG picture, one <path> for each level of speed.

#include <array>
#include <leadscrew/report/recording.hpp>
#include <leadscrew/report/speed_colors.hpp>
#include <span>
#include <string>

namespace leadscrew::report {

enum class ViewSide : std::uint8_t { top, front, right, isometric };

/// A point of the picture plane: to the right and up, mm.
struct Seen {
  double right = 0;
  double up = 0;
};

/// top: X right, Y up. front: X right, Z up. right: Y right, Z up. isometric: from the front, right and above.
Seen seen_from(ViewSide side, const base::AxisVector& position);

/// Least and greatest coordinates of a picture, mm.
struct SeenExtent {
  double left = 0, right = 0, bottom = 0, top = 0;

  double width() const { return right - left; }
  double height() const { return top - bottom; }
};
SeenExtent extent_of(std::span<const PathPoint> path, ViewSide side);

/// Where the picture plane lies in the SVG: x = x0 + scale·right, y = y0 − scale·up.
struct Placement {
  double scale = 1;  ///< units of the SVG for each mm
  double x0 = 0, y0 = 0;

  double x(double right) const { return x0 + scale * right; }
  double y(double up) const { return y0 - scale * up; }
};

/// Puts the middle of the extent into the middle of a rectangle.
Placement centred(const SeenExtent& extent, double scale, double x, double y, double width, double height);

bool has_rapids(std::span<const PathPoint> path);

/// The strokes, with classes v0 … v23 by speed, slow ones above fast ones, all above those of rapids (class rapid: thin and
/// dashed), and marks at start (ring) and end (square).
void put_strokes(std::string& out, std::span<const PathPoint> path, ViewSide side, const Placement& placement,
                 const SpeedScale& speeds, double stroke_width);

/// CSS rules of the classes v0 … v23 (as stroke) for a background.
std::string stroke_rules(Background background);

}  // namespace leadscrew::report
