#pragma once
// Thinning of a path to the points that a polyline needs to stay within a tolerance of all of them.
//
// A swing filter: from the last point kept, the anchor, every coordinate and the feed is seen as a function of the
// distance travelled d. Each point passed over leaves, for each of them, the band of slopes within which a straight
// line passes it at no more than the tolerance; the bands of all points passed over intersect.
//
//        value │        . · ' ┬ tolerance       A new point whose own slope lies within the band of each coordinate
//              │   . · ' ╳    ┴                 replaces the last one; otherwise the last one is kept and becomes
//       anchor ●' · .                           the anchor. Work and memory per point are constant.
//              └───────────────────▶ d
//
// Where a rapid and a feed move meet, the point between them is kept.
//
// After H. Elmeleegy et al., "Online piece-wise linear approximation of numerical streams with precision guarantees",
// VLDB 2009.

#include <array>
#include <cstddef>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/report/recording.hpp>
#include <span>
#include <vector>

namespace leadscrew::report {

/// How far a polyline may depart from the path it stands for.
struct ThinningTolerance {
  double position = 0;  ///< mm or degrees, in each coordinate
  double feed = 0;      ///< mm/s
};

class PathThinner {
 public:
  /// Coordinates other than `axes` are not looked at.
  PathThinner(base::AxisSet axes, ThinningTolerance tolerance);

  void tolerate(ThinningTolerance tolerance) { tolerance_ = tolerance; }

  /// The first point of the path; it is always kept.
  void begin(const PathPoint& point);

  /// Offers the next point. True when the point before it must be kept, which is then anchor().
  bool offer(const PathPoint& point);

  const PathPoint& anchor() const { return anchor_; }
  const PathPoint& last() const { return last_; }
  bool has_moved() const { return distance_ > 0; }  ///< whether last() lies away from anchor()

 private:
  struct Band {
    double least;
    double greatest;
  };

  bool within_bands(const PathPoint& point) const;
  void open_bands();
  void narrow_bands(const PathPoint& point);

  std::array<std::size_t, base::axis_count> coordinates_{};
  std::size_t count_ = 0;
  ThinningTolerance tolerance_;
  PathPoint anchor_;
  PathPoint last_;
  double distance_ = 0;  ///< from anchor_ to last_, the sum of all coordinates' travel
  std::array<Band, base::axis_count> position_bands_{};
  Band feed_band_{};
};

/// Thins points in place; the first and the last stay.
void thin(std::vector<PathPoint>& points, base::AxisSet axes, ThinningTolerance tolerance);

/// At most `most` ≥ 2 of the points, by the smallest of the tolerances `finest`·2ⁿ that does it.
std::vector<PathPoint> thinned_to(std::span<const PathPoint> points, base::AxisSet axes, std::size_t most,
                                  ThinningTolerance finest);

}  // namespace leadscrew::report
