#pragma once
// The tool path: smooth pieces joined end to end, each a curve by arc length, tolerance already spent; between them the
// dwells of the program and the events that motion rests for, each pinned to its place. All other events lie on the
// pieces: where one was programmed between two moves, at the place of the path that stands for their joint.

#include <algorithm>
#include <cstdint>
#include <leadscrew/base/event.hpp>
#include <leadscrew/base/line.hpp>
#include <leadscrew/geometry/curve.hpp>
#include <leadscrew/toolpath/axis_path.hpp>
#include <leadscrew/toolpath/contact_rate.hpp>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace leadscrew::machine {
struct Machine;
}

namespace leadscrew::toolpath {

/// From a place on, what is travelled was asked for by another line of the program.
struct LineMark {
  double s = 0;  ///< path length on the piece
  base::Line line{};
};

/// An event that motion does not rest for, where it is passed.
struct EventMark {
  double s = 0;  ///< path length on the piece: from 0 to less than its length
  base::Event event;
  // Given by the planner.
  std::int64_t number = 0;  ///< of all events that travel, in the order of the path
  double path_length = 0;   ///< since the program's start
};

/// Axes by whose motion feed is counted (RS274/NGC 2.1.2.5); or the place where the tool touches a surface.
enum class FeedAxes : std::uint8_t { none, xyz, uvw, abc, contact };

/// |dq/ds| of these axes alone, units of theirs per unit of the curve's length; 1 for none. Not of the contact.
double rate(const geometry::PointJet& jet, FeedAxes axes);
numeric::Pair rate(const geometry::PointJetOf<numeric::Pair>& jet, FeedAxes axes);
/// The same along a curve at 0 ≤ s ≤ its length, to the last bit, without what feed does not ask for. For the cycle.
double rate(const geometry::Curve& curve, double s, FeedAxes axes);

struct Piece;
struct TravelExcess;

/// Whether a piece has been found inside the travel of the machine: only check_travel() (travel.hpp) says so.
class TravelMark {
 public:
  bool is_inside() const { return passed_; }

 private:
  friend std::optional<TravelExcess> check_travel(Piece& piece, const machine::Machine& machine,
                                                  const geometry::Point& start, double slack);
  bool passed_ = false;
};

struct Piece {
  geometry::Curve curve;
  double feed = 0;  ///< greatest speed, units of the length that it is counted by per second; infinite for a rapid
  base::Line line{};
  bool stop = false;  ///< rest at the end, whatever follows (G61.1)
  /// Where it was made of more than one move: ascending by s; none otherwise.
  std::shared_ptr<const std::vector<LineMark>> lines{};
  /// Whose length feed is counted by; none: the curve's.
  FeedAxes feed_axes = FeedAxes::none;
  TravelMark travel{};
  /// That are passed on it: not descending by s; none otherwise.
  std::shared_ptr<const std::vector<EventMark>> events{};
  /// That the tolerance leaves for chords between words, mm: what the curve itself has not spent of it; 0 where the
  /// curve is what was programmed.
  double sagitta = 0;
  /// Between the curve's coordinates, those of the tool's tip and the rotary axes, and the machine's axes; none: they are
  /// the same.
  std::shared_ptr<const kinematics::Transformation> transformation{};
  /// Under tool centre point control, also where no rotary axis turns and there is no transformation.
  bool is_of_tip = false;
  /// By which feed is counted where feed_axes says so: the curve is a Nurbs then.
  std::shared_ptr<const ContactRate> contact{};
  /// The path of a motion of least time: at each knot of its curve jerk jumps as it did in that motion.
  bool is_of_least_time = false;

  /// How axes travel it.
  AxisPath axes() const { return AxisPath(curve, transformation.get()); }
  /// By feed, units of the curve's length per second; infinite where what feed is counted by stands. `jet` is that of
  /// axes() at s, 0 ≤ s ≤ length.
  double greatest_speed(double s, const geometry::PointJet& jet) const {
    if (feed_axes == FeedAxes::none) return feed;
    if (feed_axes == FeedAxes::contact || transformation) return feed / feed_rate(s);
    return feed / rate(jet, feed_axes);
  }
  /// What feed is counted by, per unit of the curve's length, at 0 ≤ s ≤ length. For the cycle.
  double feed_rate(double s) const {
    if (feed_axes == FeedAxes::none) return 1;
    const auto* const nurbs = std::get_if<geometry::Nurbs>(&curve);
    return feed_axes == FeedAxes::contact && nurbs ? contact->at(*nurbs, s) : rate(curve, s, feed_axes);
  }
  /// Are they equally fast wherever they are the same curve?
  bool is_fed_as(const Piece& other) const {
    return feed == other.feed && feed_axes == other.feed_axes && transformation == other.transformation &&
           contact == other.contact;
  }
  base::Line line_at(double s) const {
    if (!lines) return line;
    const auto behind = std::upper_bound(lines->begin(), lines->end(), s,
                                         [](double place, const LineMark& mark) { return place < mark.s; });
    return behind == lines->begin() ? line : std::prev(behind)->line;
  }
  base::Line last_line() const { return lines && !lines->empty() ? lines->back().line : line; }
};

/// Stand still.
struct Dwell {
  geometry::Point position{};
  double seconds = 0;  ///< ≥ 0
  base::Line line{};
};

using Element = std::variant<Piece, Dwell, base::Event>;

}  // namespace leadscrew::toolpath
