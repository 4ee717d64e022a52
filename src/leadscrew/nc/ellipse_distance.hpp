#pragma once
// How far a place is from an ellipse.

namespace leadscrew::nc {

struct EllipseFoot {
  double x = 0, y = 0;  ///< the point of the ellipse that is nearest
  double distance = 0;  ///< > 0 outside, < 0 inside
};

/// Of the ellipse about the origin with these semi-axes > 0 along X and Y, to about 1e-14 of the longer one. Where several
/// points are equally near, one of them.
EllipseFoot foot_on_ellipse(double semi_x, double semi_y, double x, double y);

}  // namespace leadscrew::nc
