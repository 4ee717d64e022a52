#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/language/lint.hpp>
#include <limits>
#include <utility>

namespace leadscrew::language {

namespace {

using base::Axis;
using gcode::Move;

constexpr int most_told = 10;              // of each code
constexpr double rounding = 1e-6;          // mm
constexpr double least_usual_feed = 30;    // mm/min: 1.2 inches/min
constexpr double least_length_told = 1.0;  // mm

double z_of(const base::AxisVector& position) {
  return position[base::index(Axis::Z)];
}

// On lathes Z says nothing of the stock's top; where the work is in the machine's coordinates, nobody knows here; and
// G76 and G87 take the tool off the wall of their bore at its bottom.
bool knows_top(const Move& move, const gcode::ModalState& modal) {
  const bool leaves_wall = modal.motion == gcode::Code::G76_bore || modal.motion == gcode::Code::G87;
  return modal.plane != gcode::Plane::ZX && modal.in_machine != move.line && !leaves_wall;
}

double length_in_plane(const Move& move) {
  return std::hypot(move.end[0] - move.start[0], move.end[1] - move.start[1]);
}

}  // namespace

std::vector<base::Diagnostic> Lint::see(const Move& move, const gcode::Frame& frame, const gcode::ModalState& modal) {
  found_.clear();
  if (move.kind == Move::Kind::event) {
    see_event(move.event);
  } else if (move.kind != Move::Kind::dwell) {
    const double top = frame.offset()[base::index(Axis::Z)] + stock_top_;
    if (std::hypot(move.start[0] - x_, move.start[1] - y_) > rounding) depth_ = std::numeric_limits<double>::infinity();
    if (move.feed.mode == gcode::Feed::Mode::rapid) {
      if (knows_top(move, modal)) see_rapid(move, top);
    } else if (!move.is_probing()) {  // which cuts nothing
      see_feed(move, top, modal);
      see_unit(move, frame);
    }
    const bool stays = length_in_plane(move) <= rounding;
    if (!stays) depth_ = std::numeric_limits<double>::infinity();
    if (move.feed.mode != gcode::Feed::Mode::rapid) depth_ = std::min(depth_, z_of(move.end));
    x_ = move.end[0];
    y_ = move.end[1];
  }
  return std::exchange(found_, {});
}

void Lint::see_event(const base::Event& event) {
  using Kind = base::Event::Kind;
  if (event.kind == Kind::tool_prepare || base::changes_tool(event.kind)) has_tool_ = true;
  if (base::stops_spindle(event.kind)) spindle_on_ = false;
  if (event.kind == Kind::spindle_clockwise || event.kind == Kind::spindle_counterclockwise) {
    spindle_on_ = true;
    told_of_spindle_ = false;
  }
}

void Lint::see_feed(const Move& move, double top, const gcode::ModalState& modal) {
  if (std::min(z_of(move.start), z_of(move.end)) >= top - rounding || machine_.laser) return;
  const bool changes_tools = machine_.dialect != machine::Dialect::grbl && machine_.dialect != machine::Dialect::marlin;
  if (!has_tool_ && changes_tools) {
    warn("lint-no-tool", "the program cuts and has called no tool", "T1 M6 before the first cut");
    has_tool_ = true;
  }
  // Fanuc's and Haas' tapping cycles turn the spindle themselves.
  const bool taps = gcode::is_of_fanuc_family(machine_.dialect) &&
                    (modal.motion == gcode::Code::G74 || modal.motion == gcode::Code::G84);
  if (!spindle_on_ && !told_of_spindle_ && !taps) {
    warn("lint-spindle-off", "the program cuts while the spindle is off", "S1000 M3 before the cut");
    told_of_spindle_ = true;
  }
}

void Lint::see_rapid(const Move& move, double top) {
  const double deepest = std::min(z_of(move.start), z_of(move.end));
  if (deepest >= top - rounding || machine_.laser) return;
  const bool sideways = length_in_plane(move) > rounding;
  const bool into_work = z_of(move.end) < z_of(move.start) - rounding && z_of(move.end) < depth_ - rounding;
  if (!sideways && !into_work) return;
  warn("lint-rapid", fmt::format("a rapid {:g} mm below the top of the stock", top - deepest),
       "lift the tool first, move at feed, or say where the top is");
}

void Lint::see_unit(const Move& move, const gcode::Frame& frame) {
  if (move.feed.mode != gcode::Feed::Mode::units_per_second || frame.length_unit != 1) return;
  const double feed = move.feed.value * 60;
  if (feed >= least_usual_feed || length_in_plane(move) < least_length_told) return;
  warn("lint-feed-unit", fmt::format("a feed of {:g} mm/min under G21", feed),
       fmt::format("is it meant in inches? F{:g}, or G20", feed * 25.4));
}

void Lint::warn(std::string_view code, std::string message, std::string hint) {
  if (++told_[code] > most_told) return;
  base::Diagnostic found = base::problem(code, std::move(message), std::move(hint));
  found.severity = base::Severity::warning;
  found_.push_back(std::move(found));
}

}  // namespace leadscrew::language
