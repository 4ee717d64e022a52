#pragma once
// Within its tolerances, the path that a machine travels in the least time: lines, arcs and what stands for curves in X,
// Y and Z, as one smooth path that uses the corridor around them on both sides. It swings wide before corners and cuts
// them, several at once where they lie close together, as the machine's limits of velocity, acceleration and jerk ask.
//
//     legs ─▶ corridor ─window by window─▶ motion of least time (corridor_optimum.hpp) ─▶ its path, as pieces
//
// Only the path of that motion is kept. A window ends at rest, and what lies so near its end that a stop there has an
// influence is planned anew by the next, which begins with the last control points that are kept. The middle of long
// lines and arcs stays exact: there a window ends and the next begins in motion along them. Each window's motion is
// proven to be inside the tolerance (corridor_check.hpp); where none is found, legs are kept as they are, with stops.

#include <deque>
#include <leadscrew/machine/derivatives.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/toolpath/corridor.hpp>
#include <leadscrew/toolpath/knot_removal.hpp>
#include <leadscrew/toolpath/leg.hpp>
#include <leadscrew/toolpath/reduction.hpp>
#include <memory>
#include <optional>
#include <vector>

namespace leadscrew::toolpath {

class RacingLine {
 public:
  explicit RacingLine(const machine::Machine& machine);

  /// Is it a leg in X, Y and Z alone that may be fitted, within a micrometre or more?
  static bool takes(const Leg& leg);

  /// Of the leg's allowance, P of G64, mm: no point of the path lies farther from what was programmed there, and no point
  /// of that farther from the path; of short legs Q, if that is less.
  void push(Leg leg);
  /// Motion rests behind what was pushed last.
  void finish();
  /// The next piece that nothing ahead can change.
  std::optional<Piece> pop();
  /// After finish(): events that lie where the last piece ends.
  const std::vector<EventMark>& events_at_end() const { return carried_; }

 private:
  using Place = Vector<3>;

  /// What was programmed from u on, u the length of all legs.
  struct Source {
    double u = 0;
    std::shared_ptr<const Leg> leg;
  };
  /// An event that is passed at u.
  struct UpcomingEvent {
    double u = 0;
    base::Event event;
  };
  /// Of the legs at hand.
  struct Window {
    std::size_t count = 0;
    CorridorEnd end = CorridorEnd::rest;
    double finish = 0;            ///< on the last leg, mm
    bool is_provisional = false;  ///< it ends at rest only as far as it is known
  };
  /// A motion along the legs at hand, from a knot on.
  struct Plan {
    TimeSpline<3> motion;
    std::size_t count = 0;  ///< of legs
  };

  void take(Leg leg);
  void append(const CorridorLeg<3>& leg, double length);
  bool merge(const CorridorLeg<3>& line, double length, double speed);
  void advance(bool all);
  bool emit_long_start();
  std::vector<bool> block_ends() const;
  bool stays(const Window& window) const;
  std::optional<Window> choose(bool all) const;
  double seconds_along(std::size_t leg) const;
  double stop_time() const;
  double speed_at(std::size_t joint) const;
  bool turns_back(std::size_t joint) const;
  double speed_along(const CorridorLeg<3>& leg) const;
  double reach_of(const CorridorLeg<3>& leg) const;
  bool is_long(std::size_t leg) const;
  std::array<Place, 3> points_at(const CorridorLeg<3>& leg, double s, double interval) const;
  std::optional<Plan> plan(const Window& window);
  void accept(Plan plan, const Window& window);
  void retreat(const Window& window);
  void emit(const Plan& plan, std::size_t from, std::size_t to);
  void emit_exact(double from, double to);
  Nearness nearness_of(const Plan& plan) const;
  double time_at(const Plan& plan, double u) const;
  void drop_before(std::size_t leg);
  void give(Piece piece);

  CorridorLimits<3> limits_;
  machine::Derivatives least_;  ///< of the slowest axes
  Reduction reduction_;
  std::deque<CorridorLeg<3>> legs_;  ///< that are not done
  std::deque<bool> is_exact_;        ///< is each all along what was programmed, and not only at its ends?
  std::deque<double> borders_;       ///< u where they begin, and where the last one ends
  std::deque<double> clock_;         ///< about when they end, s; not known of the last
  double clock_begin_ = 0;           ///< and when the first begins
  double fastest_ = 0;               ///< speed of any leg so far, mm/s
  std::deque<Source> sources_;
  std::deque<UpcomingEvent> events_;  ///< that are not done
  std::vector<Place> merged_;         ///< where the lines that became the last leg meet
  double merged_margin_ = 0;          ///< mm, that they have
  geometry::Point others_{};          ///< all other coordinates
  bool is_moving_ = false;            ///< does the path go on?
  double begin_ = 0;                  ///< on the first leg, mm
  std::array<Place, 3> given_{};      ///< then: its last control points
  double given_interval_ = 0;         ///< s, that they were made for
  bool begins_on_leg_ = false;        ///< exactly, where any interval would do
  double interval_ratio_ = 1;         ///< of what a window's interval came out to be, and what it was begun with
  std::optional<Plan> rest_;          ///< then: what was planned on from there, to rest
  std::vector<EventMark> carried_;    ///< events at the end of the last piece that is done
  std::deque<Piece> done_;
};

}  // namespace leadscrew::toolpath
