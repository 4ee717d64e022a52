#pragma once
// Which lines of the surface passes follow, one after another: each is found from the one before and the height that the
// ridge between them may have.

#include <leadscrew/surfaces/pass_nodes.hpp>
#include <leadscrew/surfaces/reach.hpp>
#include <memory>
#include <utility>

namespace leadscrew::surfaces {

/// The lines of a pattern, in order.
class PassLines {
 public:
  virtual ~PassLines() = default;
  /// Those of the next pass, in the order in which they are gone: more than one where the pass is cut by the range's border. None at
  /// the end, or where the log has a failure.
  virtual std::vector<Line> next(PassLog& log) = 0;
};

/// Of the machining's pattern.
std::unique_ptr<PassLines> lines_of(PassLog& log);

/// Lines of a pattern, kept, so that the same passes are made again without finding them.
struct LineRecord {
  static constexpr std::size_t most_bytes = 1 << 20;  ///< if they are more, none are kept

  std::vector<std::vector<Line>> passes;
  std::size_t bytes = 0;     ///< of all passes
  bool is_complete = false;  ///< all are here, to the end
};
/// Tells what the lines tell, and keeps that in the record.
std::unique_ptr<PassLines> recorded_lines(std::unique_ptr<PassLines> lines, std::shared_ptr<LineRecord> record);
/// Of a record that is complete.
std::unique_ptr<PassLines> known_lines(std::shared_ptr<const LineRecord> record);

/// The log tells of an edge inside the range, whether a pass would cross it or go by.
void look_for_edges(PassLog& log);

std::unique_ptr<PassLines> spiral_lines(PassLog& log);
std::unique_ptr<PassLines> planar_lines(PassLog& log);
std::unique_ptr<PassLines> iso_scallop_lines(PassLog& log);

/// mm on the surface across a pass, for the ridge that may be left; no_step where the log fails. towards: on the surface, to the
/// side where the next pass lies.
double step_at(PassLog& log, const Contact& contact, const LinePlace& place, const Vector& towards);

/// From where to where passes are gone, by the machining's start corner.
struct Course {
  Direction along = Direction::u;
  double from = 0, to = 0;     // of the first pass
  double first = 0, last = 0;  // across

  Range run() const { return {std::min(from, to), std::max(from, to)}; }
  Range width() const { return {std::min(first, last), std::max(first, last)}; }
  double sign_across() const { return last < first ? -1 : 1; }
};
Course course_of(const Machining& machining, Direction along);

/// Places along a range of one parameter where steps are found: both ends, and some inside each span of the surface.
std::vector<double> places_along(const Surface& surface, Direction along, const Range& range, std::size_t least);

/// With those where the coordinate, 0 to 2, is least or greatest on the border or on a break across: between two of them a plane meets
/// neither more than once.
std::vector<double> section_places(const Surface& surface, const Course& course, std::size_t coordinate,
                                   const std::vector<double>& places);
inline constexpr double least_section_gap = 1e-6;  ///< between places, and of a section from part to part, of the range

/// At a place of a line: g, mm, and w, mm of the surface across the line for one unit of what tells lines apart.
struct StepPlace {
  double step = 0, width = 1;
};
/// Along a line at a constant parameter across: none where the log fails. direction: 1 or −1, in which the pass is gone; towards: 1
/// or −1, where the next pass lies.
std::vector<StepPlace> steps_along(PassLog& log, Direction along, const std::vector<double>& places, double across,
                                   double direction, double towards);

/// g/w from one line to another, of places at both and in the middle. Where curvature changes between two passes, the ridge has a quarter of
/// that at each and half of that in the middle, as it is summed twice from both contacts; w is summed once (Simpson's rule).
double step_between(const StepPlace& here, const StepPlace& middle, const StepPlace& there);

/// The least g/w of one line, by a parabola.
double least_on(const std::vector<double>& places, const std::vector<StepPlace>& line);

/// Of a line at a constant parameter across: how far from it it alone leaves no more than the height, and how far ahead of contacts and
/// behind them, at the most, the edge is there to either side: parameters, 0 or more.
struct LineReach {
  double across = 0, ahead = 0, behind = 0;
};

/// Steps from one line at a constant parameter across to the next.
class LineSteps {
 public:
  LineSteps(Direction along, std::vector<double> places) : along_(along), places_(std::move(places)) {}

  const std::vector<double>& places() const { return places_; }
  /// Of the parameter across; left: how much of it there is to the end; guess: about the step, or 0. Not 0 but where the log fails.
  double next(PassLog& log, double across, double left, double direction, double towards, double guess);
  /// Of a tool that has_reach(), from one line alone; none where a place has none, or the log fails.
  std::optional<LineReach> reach(PassLog& log, double across, double direction, double towards) const;

 private:
  double by_rule(PassLog& log, double across, double left, double direction, double towards, double guess);
  std::optional<Reaches> reaches_of(PassLog& log, double across, double direction, double towards) const;
  std::optional<double> by_reach(PassLog& log, double across, double left, double direction, double towards,
                                 double guess) const;

  Direction along_;
  std::vector<double> places_;
  std::vector<StepPlace>
      there_;  // of the line that was come to last, where the tool is the same whatever the direction
};

/// Whether the steps of lines at a constant parameter across are more than passes may be, found from some: the log tells then.
bool are_too_many(PassLog& log, const Course& course, const std::vector<double>& places);

/// The least of a function known at some places, ascending, by a parabola; no less than 0.9 of the least value.
double least_of(const std::vector<double>& places, const std::vector<double>& values);

}  // namespace leadscrew::surfaces
