#include <algorithm>
#include <cmath>
#include <leadscrew/toolpath/event_marks.hpp>
#include <leadscrew/toolpath/stretch.hpp>
#include <utility>

namespace leadscrew::toolpath {

Lines lines_between(const Piece& piece, double from, double to, double longer) {
  Lines lines{piece.line, {}};
  if (!piece.lines) return lines;
  for (const LineMark& mark : *piece.lines) {
    if (mark.s <= from) {
      lines.first = mark.line;
    } else if (mark.s < to) {
      lines.marks.push_back({longer * (mark.s - from), mark.line});
    }
  }
  return lines;
}

void name(Piece& piece, Lines lines) {
  piece.line = lines.first;
  piece.lines = lines.marks.empty() ? nullptr : std::make_shared<const std::vector<LineMark>>(std::move(lines.marks));
}

void trim(Piece& piece, double from, double to) {
  const double length = geometry::length(piece.curve);
  if (from == 0 && to == length) return;
  set_events(piece, events_on({from, to, length}, events_of(piece)));
  piece.curve = geometry::part(piece.curve, from, to);
  name(piece, lines_between(piece, from, to));
}

/// False position, which soon finds it where u is nearly the length, and bisection.
double length_at(const geometry::Nurbs& curve, double u) {
  const double tolerance = 1e-10 * (curve.last_parameter() - curve.first_parameter());
  double low = 0, high = curve.length(), u_low = curve.first_parameter(), u_high = curve.last_parameter();
  for (int k = 0; k < 60; ++k) {
    const double share = k % 3 == 2 ? 0.5 : (u - u_low) / (u_high - u_low);
    const double s = low + std::clamp(share, 0.0, 1.0) * (high - low), here = curve.parameter(s);
    if (std::abs(here - u) <= tolerance) return s;
    (here < u ? low : high) = s;
    (here < u ? u_low : u_high) = here;
  }
  return low;
}

namespace {

/// The chord of what was programmed that leads away from the end; u: of the end.
std::size_t chord_from(const std::vector<Vertex>& vertices, StretchEnd end, double u) {
  std::size_t chord = 1;
  while (chord + 1 < vertices.size() && (end == StretchEnd::first ? vertices[chord].u <= u : vertices[chord].u < u))
    ++chord;
  return chord;
}

double parameter_at(const geometry::Nurbs& curve, StretchEnd end) {
  return curve.parameter(end == StretchEnd::first ? 0 : curve.length());
}

}  // namespace

double tolerance_at(const Stretch& stretch, StretchEnd end) {
  const auto* const nurbs = std::get_if<geometry::Nurbs>(&stretch.piece.curve);
  if (stretch.programmed.empty() || !nurbs) return stretch.tolerance;
  return stretch.programmed[chord_from(stretch.programmed, end, parameter_at(*nurbs, end))].tolerance;
}

Reach reach_within(const Stretch& stretch, StretchEnd end, double tolerance, double most) {
  const std::vector<Vertex>& vertices = stretch.programmed;
  const auto* const nurbs = std::get_if<geometry::Nurbs>(&stretch.piece.curve);
  if (vertices.empty() || !nurbs) return {most, 0};
  const double length = nurbs->length();
  const double farthest = nurbs->parameter(end == StretchEnd::first ? most : length - most);
  std::size_t chord = chord_from(vertices, end, parameter_at(*nurbs, end));
  if (end == StretchEnd::first) {
    while (vertices[chord].tolerance >= tolerance) {
      if (vertices[chord].u >= farthest) return {most, 0};
      if (++chord == vertices.size()) return {most, 0};
    }
    return {length_at(*nurbs, std::max(vertices[chord - 1].u, nurbs->first_parameter())), vertices[chord].tolerance};
  }
  while (vertices[chord].tolerance >= tolerance) {
    if (vertices[chord - 1].u <= farthest) return {most, 0};
    if (--chord == 0) return {most, 0};
  }
  return {length - length_at(*nurbs, std::min(vertices[chord].u, nurbs->last_parameter())), vertices[chord].tolerance};
}

}  // namespace leadscrew::toolpath
