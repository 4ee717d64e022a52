#pragma once
// What a report needs of slides that followed words, in memory that does not grow with them: errors over time, in the
// bins of the words' Recording, the ideal path, and places of slides with the places of the path they are matched to.
// Where there are too many of these, of two neighbours the one with the greater error stays.

#include <array>
#include <leadscrew/report/bounded_path.hpp>
#include <leadscrew/report/envelope.hpp>
#include <vector>

namespace leadscrew::report {

/// mm and degrees.
struct FollowedPoint {
  base::AxisVector actual{};
  base::AxisVector nearest{};  ///< on the path of the words
  double distance = 0;         ///< mm
};

/// Of one axis at one word; mm, degrees and seconds.
struct FollowedAxis {
  double error = 0;     ///< commanded less actual
  double velocity = 0;  ///< by the tachometer
  double control = 0;   ///< what the controller gives the drive, in its units
  double current = 0;   ///< of the motor, as the acceleration that it gives
};

class FollowedRecording {
 public:
  static constexpr std::size_t most_points = 6000;

  explicit FollowedRecording(base::AxisSet axes);

  /// Point after point along the programmed geometry.
  void observe_ideal(const base::AxisVector& position) { ideal_.observe({position, 0}); }
  /// Once for each word that is recorded: its axes, and the measured feed, mm/s.
  void observe(const std::array<FollowedAxis, base::axis_count>& axes, double feed);
  /// Of so many periods, which may come later than they.
  void observe(const FollowedPoint& point, std::int64_t periods);

  std::span<const Extent> feed() { return axes_of_words_.channel(0); }
  std::span<const Extent> axis(base::Axis axis, double FollowedAxis::* value);
  std::span<const Extent> contour() { return contour_.channel(0); }

  std::span<const PathPoint> ideal() { return ideal_.points(); }
  std::span<const FollowedPoint> points() const { return points_; }  ///< in the order of time
  double greatest_contour() const { return greatest_; }              ///< mm

 private:
  void thin_points();

  base::AxisSet axes_;
  Envelope axes_of_words_, contour_;
  BoundedPath ideal_;
  std::vector<FollowedPoint> points_;
  std::int64_t each_ = 1, since_ = 0;  ///< points that are seen to one that is kept
  FollowedPoint worst_;                ///< of those since the last one kept
  std::int64_t words_ = 0, matched_ = 0;
  double greatest_ = 0;
};

}  // namespace leadscrew::report
