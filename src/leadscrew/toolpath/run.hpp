#pragma once
// A run of the path that is fitted: short legs joined smoothly and the nearest parts of long ones, as a spline through
// the tube around them (tube_spline.hpp). Where no spline stays inside, it ends at the sharpest vertex near by, with a
// corner there, and another begins.

#include <cmath>
#include <deque>
#include <leadscrew/toolpath/leg.hpp>
#include <leadscrew/toolpath/stretch.hpp>
#include <leadscrew/toolpath/tube_spline.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace leadscrew::toolpath {

class Run {
 public:
  /// From a place on the leg, with its direction and bend if `pinned`, else in any direction.
  Run(const Leg& leg, double from, bool pinned, bool corner_before, const geometry::MapTolerance& tables);

  /// Goes on along the leg, 0 ≤ from < to ≤ its length.
  void extend(const Leg& leg, double from, double to);
  /// Ends at a place on the leg, where extend() has led to; not to be extended any more.
  void end(const Leg& leg, double to, bool pinned);
  /// What has been settled since the last call, in order.
  std::vector<Stretch> take() { return std::exchange(done_, {}); }
  /// After end() and take(): the events that lie where the run ends.
  std::vector<base::Event> events_left() const;

 private:
  struct Mark {
    double u = 0;
    double feed = 0;
    double speed = 0;  ///< by feed, mm/s
    base::Line line{};
  };
  /// Feed that is held, as no line is fed more slowly there.
  struct Hold {
    double feed = 0;
    double until = 0;  ///< u
  };

  /// An event that is passed.
  struct Passing {
    double u = 0;
    base::Event event;
  };

  std::vector<Passing> events_before(double u);
  static TubeSpline spline_from(const Leg& leg, double from, bool pinned);
  void settle();
  bool begin_rest(bool corner);
  bool retreat();
  void add_spline(const std::vector<Vertex>& around, double from, bool is_last);
  std::size_t mark_at(double u, std::size_t from) const;
  Hold hold_from(double u, std::size_t mark) const;
  double fed_until(const geometry::Nurbs& curve, double begin, double& feed, double& u);

  geometry::MapTolerance tables_;
  ToleranceSpace space_;           ///< of all its legs
  FeedAxes axes_;                  ///< by which the feed of all its legs is counted
  Allowance allowance_;            ///< of the last leg
  double u_ = 0;                   ///< as far as it is known
  std::deque<Mark> marks_{};       ///< by u; the first holds where the next stretch begins
  std::deque<Passing> events_{};   ///< by u; that are not settled
  Hold hold_{};                    ///< where the next stretch begins
  geometry::Point start_, end_{};  ///< where the spline begins and is to end, in the axes' units
  double spent_ = 0;               ///< by any of its legs
  bool is_first_ = true;           ///< has nothing of the spline been settled?
  bool corner_before_;             ///< of the spline
  std::optional<State> last_{};    ///< at the end of the run, once that is known
  geometry::Point last_point_{};   ///< likewise, in the axes' units
  std::vector<Vertex> rest_{};     ///< from where the spline is to end, if that is not the end of the run
  TubeSpline spline_;
  std::vector<Stretch> done_;
};

}  // namespace leadscrew::toolpath
