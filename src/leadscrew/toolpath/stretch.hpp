#pragma once
// A part of the path that is done but for its corners, and what it was made of.

#include <cmath>
#include <leadscrew/toolpath/path.hpp>
#include <leadscrew/toolpath/tube_spline.hpp>
#include <vector>

namespace leadscrew::toolpath {

struct Stretch {
  Piece piece;
  FeedAxes axes{};  ///< by which feed is counted
  bool corner_before = false;
  std::vector<Vertex> programmed{};  ///< the polyline it was fitted to; none if it is what was programmed
  double tolerance = 0;              ///< then: P, mm; else the vertices say it
  double spent = 0;                  ///< of the tolerance, by what stands for what was programmed, mm
  bool cut = false;                  ///< at its start, by a blend
  double length = 0;                 ///< before that
  double wanted_behind = INFINITY;   ///< of its length, by what is at its end; infinite if that is not known
};

/// The lines that a part of a piece was asked for by.
struct Lines {
  base::Line first{};
  std::vector<LineMark> marks;  ///< of the others, from the beginning of the part
};

/// Between two path lengths; places are told by what stands for that part, which is so much longer.
Lines lines_between(const Piece& piece, double from, double to, double longer = 1);

void name(Piece& piece, Lines lines);

/// Leaves what lies between two path lengths, with its lines and events.
void trim(Piece& piece, double from, double to);

/// Arc length at parameter u.
double length_at(const geometry::Nurbs& curve, double u);

enum class StretchEnd : std::uint8_t { first, last };

/// P of what was programmed at an end of the stretch, mm.
double tolerance_at(const Stretch& stretch, StretchEnd end);

/// How far from that end P is no less than `tolerance`: at most `most` of the piece's length. `beyond`: P there, mm; 0
/// if it is nowhere less on that much.
struct Reach {
  double length = 0;
  double beyond = 0;
};
Reach reach_within(const Stretch& stretch, StretchEnd end, double tolerance, double most);

}  // namespace leadscrew::toolpath
