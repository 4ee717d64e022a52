#pragma once
// What one block of a part program asks for, as plain data: the interface between the reader and the tool path.

#include <array>
#include <cstddef>
#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/event.hpp>
#include <leadscrew/base/line.hpp>
#include <vector>

namespace leadscrew::gcode {

/// The plane of arcs: its two axes, in the order in which a counterclockwise arc turns the first towards the second, as
/// seen from the positive end of the third.
/// There are no arcs in those of U, V and W: canned cycles alone lie across them.
enum class Plane : std::uint8_t { XY, ZX, YZ, UV, WU, VW };  // G17, G18, G19, G17.1, G18.1, G19.1

/// Is it of U, V and W?
constexpr bool is_secondary(Plane plane) {
  return plane > Plane::YZ;
}
/// That of X, Y and Z whose axes are beside its own; itself where it is of them.
constexpr Plane primary_of(Plane plane) {
  return is_secondary(plane) ? static_cast<Plane>(static_cast<int>(plane) - 3) : plane;
}
/// The axis beside it, of U, V and W, where the plane is theirs: else X, Y or Z itself.
constexpr base::Axis axis_in(Plane plane, base::Axis axis) {
  constexpr std::size_t from_x_to_u = base::index(base::Axis::U) - base::index(base::Axis::X);
  return is_secondary(plane) ? base::all_axes[base::index(axis) + from_x_to_u] : axis;
}

/// From it angles in the plane are counted: X of XY, Z of ZX, Y of YZ.
constexpr base::Axis first_axis(Plane plane) {
  const Plane primary = primary_of(plane);
  return axis_in(plane, primary == Plane::XY ? base::Axis::X : primary == Plane::ZX ? base::Axis::Z : base::Axis::Y);
}
/// A quarter turn on from the first.
constexpr base::Axis second_axis(Plane plane) {
  const Plane primary = primary_of(plane);
  return axis_in(plane, primary == Plane::XY ? base::Axis::Y : primary == Plane::ZX ? base::Axis::X : base::Axis::Z);
}
/// Helices climb along it.
constexpr base::Axis normal_axis(Plane plane) {
  const Plane primary = primary_of(plane);
  return axis_in(plane, primary == Plane::XY ? base::Axis::Z : primary == Plane::ZX ? base::Axis::Y : base::Axis::X);
}

/// What a probing move looks for.
enum class ProbeSearch : std::uint8_t {
  nothing,  ///< it is none
  contact,  ///< G38.2, G38.3, G31: ends where the probe touches
  loss,     ///< G38.4, G38.5: ends where it touches no more
};

/// What happens where two blocks meet.
enum class PathMode : std::uint8_t {
  exact_path,  ///< G61: on the path, without a needless stop
  exact_stop,  ///< G61.1: rest at the end of every block
  blend,       ///< G64: within the tolerance of the path
};

/// How fast along the path. Path length is that of X Y Z together; of U V W where X Y Z stand still; of A B C (degrees)
/// where all linear axes stand still (RS274/NGC 2.1.2.5, LinuxCNC "feed rate").
struct Feed {
  /// How it is said.
  enum class Mode : std::uint8_t {
    rapid,             ///< G0: axis limits only; value unused
    units_per_second,  ///< G94: value is mm/s or degrees/s; > 0
    per_second,        ///< G93: value is the reciprocal of the block's duration, 1/s; > 0
  };
  Mode mode = Mode::rapid;  ///< by which the value counts
  double value = 0;         ///< as Mode says
  /// Of G95, what F says: the value at one revolution a minute, mm/s or degrees/s. Else 0.
  double per_revolution = 0;
};

/// The curves there are: of degree 1 … highest_degree, with at most so many control points, so that memory is bounded.
inline constexpr int highest_degree = 5;
inline constexpr std::size_t most_control_points = 4096;  ///< of a curve

/// A control point of a NURBS curve.
struct ControlPoint {
  base::AxisVector position{};  ///< machine coordinates, mm or degrees
  double weight = 1;            ///< 1e-9 … 1e9

  friend bool operator==(const ControlPoint&, const ControlPoint&) = default;
};

/// A rational B-spline curve C(u) = Σ w_i N_i,p(u) P_i / Σ w_i N_i,p(u), knots[p] ≤ u ≤ knots[n] for n control points
/// (Piegl and Tiller, "The NURBS Book", eq. 4.1). It is clamped: the first p + 1 knots are equal and so are the last,
/// so that it begins at its first control point and ends at its last.
struct NurbsCurve {
  int degree = 0;                    ///< p, 1 … highest_degree; 0 where there is no curve
  std::vector<ControlPoint> points;  ///< p < n ≤ most_control_points
  /// n + p + 1, not decreasing; no inner one more than p times; neighbours are equal or at least 1e-12 of the whole
  /// range apart.
  std::vector<double> knots;
  /// X, Y and Z of the control points, mm, as many as `points` and by the same knots, of the path along a surface of the
  /// place where the tool touches it: feed is that place's. None: feed is that of the curve. All weights are then 1.
  std::vector<std::array<double, 3>> contact;

  /// No curve, in the same memory.
  void clear() {
    degree = 0;
    points.clear();
    knots.clear();
    contact.clear();
  }

  friend bool operator==(const NurbsCurve&, const NurbsCurve&) = default;
};

/// Within a tolerance of less, mm, a path is kept as programmed: no machine could show the difference.
inline constexpr double least_rounded = 2e-4;

/// What one block, or one pass of a canned cycle, asks of the axes: from the end of the move before. Fields that a kind
/// does not name are not read.
struct Move {
  /// Its shape.
  enum class Kind : std::uint8_t {
    line,   ///< straight in all axes, from start to end
    arc,    ///< circular in the plane's axes, straight in all others (a helix where the normal axis moves)
    nurbs,  ///< along `curve`, in all axes
    dwell,  ///< G4: stand still for dwell_seconds
    event,  ///< `event` happens here
  };

  Kind kind = Kind::line;                     ///< its shape
  PathMode path_mode = PathMode::blend;       ///< how it is joined to the next
  Plane plane = Plane::XY;                    ///< of an arc
  ProbeSearch probes = ProbeSearch::nothing;  ///< a line that a probe ends: motion rests before and behind it
  base::Line line{};                          ///< source line
  base::AxisVector start{};                   ///< machine coordinates, mm or degrees; the end of the move before
  base::AxisVector end{};                     ///< machine coordinates, mm or degrees
  Feed feed;                                  ///< how fast, along it
  double tolerance = 0;                       ///< mm; P of G64, or the machine's; 0 unless path_mode is blend
  double naive_cam_tolerance = 0;             ///< mm; Q of G64, or P where Q was not given; 0 unless path_mode is blend

  /// Arc: machine coordinates of the centre along first_axis and second_axis, mm. Both ends lie on the circle around it
  /// to within a few units in the last place: a programmed centre that is off by less than the tolerance has been moved
  /// to the perpendicular bisector of the ends by the reader.
  double center_first = 0;
  double center_second = 0;  ///< the second of them
  /// Arc: number of turns begun, counterclockwise (G3) positive: ±1 for an arc of up to one turn, ±n for n − 1 whole
  /// turns and an arc of up to one turn, P words of LinuxCNC. An arc whose ends coincide in the plane makes |turns|
  /// whole turns.
  int turns = 0;

  NurbsCurve curve;  ///< of a nurbs: its first control point is at start, its last at end, and not all are at start

  /// Tool centre point control (G43.4): X, Y and Z of all places are those of the tool's tip in the workpiece as it lies
  /// with all rotary axes at 0, and not of the machine's axes.
  bool is_of_tip = false;
  std::array<double, 3> tool{};      ///< of the tip: X, Y and Z of the tool's offset, mm
  double orientation_tolerance = 0;  ///< of the tip: E of G64, or the machine's, degrees; 0 unless path_mode is blend

  double dwell_seconds = 0;  ///< ≥ 0
  base::Event event;         ///< of an event

  /// Does a probe end it?
  bool is_probing() const { return probes != ProbeSearch::nothing; }
};

}  // namespace leadscrew::gcode
