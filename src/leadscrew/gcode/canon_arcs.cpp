// Arcs, and those of which nothing is told.

#include <cstdlib>
#include <leadscrew/gcode/arc.hpp>
#include <leadscrew/gcode/canon.hpp>

namespace leadscrew::gcode {

namespace {

/// Of less than half a turn: as seen from the middle, the end is on the side of the start to which the arc turns.
bool is_short(const Move& move) {
  const PlanePoint start = in_plane(move.start, move.plane), end = in_plane(move.end, move.plane);
  const double side = (start.first - move.center_first) * (end.second - move.center_second) -
                      (start.second - move.center_second) * (end.first - move.center_first);
  return std::abs(move.turns) == 1 && move.turns * side > 0;
}

}  // namespace

/// With an end that is printed as its start is, a short arc would be read as a full circle. rs274 has none of a corner.
bool CanonWriter::is_untold(const Move& move, const Frame& frame) {
  if (!is_short(move)) return false;
  const auto printed = [&](const base::AxisVector& place) {
    std::string text;
    first_argument_ = true;
    coordinates(frame.to_program(place), text);
    return text;
  };
  return printed(move.start) == printed(move.end);
}

void CanonWriter::write_arc(const Move& move, const Frame& frame, std::string& text) {
  const std::size_t first = base::index(first_axis(move.plane)), second = base::index(second_axis(move.plane));
  const base::AxisVector end = frame.to_program(move.end);
  base::AxisVector center = move.end;
  center[first] = move.center_first;
  center[second] = move.center_second;
  center = frame.to_program(center);
  call("ARC_FEED(", text);
  for (const double value : {end[first], end[second], center[first], center[second]}) {
    number(value / printed_.unit, text);
  }
  text += ", " + std::to_string(move.turns);
  axes(end, base::index(normal_axis(move.plane)), 1, text);
  const std::size_t rotary = base::index(base::Axis::A), uvw = base::index(base::Axis::U);
  axes(end, rotary, (has_uvw_ ? base::axis_count : uvw) - rotary, text);
  text += ")\n";
}

}  // namespace leadscrew::gcode
