#pragma once
// One pass over a curved patch with the tool along its normal, by five axes: as a path of tip and rotary axes, and as an
// off-line program has it, lines whose ends alone are right.
//
// The patch is a bicubic Bézier surface whose control points stand 20 mm apart in x and y, so that it is the graph of a
// height: S(u, v) = (60 u, 60 v, z(u, v)). The tool is a ball and its tip is at the surface, for it leans along the
// normal. The machine is a trunnion, A outside, C inside, none of whose axes meet.

#include <leadscrew/kinematics/chain.hpp>
#include <leadscrew/kinematics/pose.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/study/curves.hpp>
#include <string>
#include <vector>

namespace leadscrew::study {

using kinematics::Vector;

/// The trunnion: X Y Z of 400 mm/s, 3000 mm/s², 60 000 mm/s³; A of 180°/s, 1500°/s², 30 000°/s³; C twice as fast. Words
/// come every millisecond. A turns about (−4, 5, 6) mm, C about (1, 2, 3) mm.
machine::Machine trunnion();

/// The tip and the rotary axes, all in one vector: X Y Z of the tip in the workpiece, mm; A and C of the machine, degrees.
using TipAndRotary = base::AxisVector;

/// The pass v = 0.75, 0 ≤ u ≤ 1.
class SurfacePass {
 public:
  explicit SurfacePass(const kinematics::Chain& chain) : chain_(chain) {}

  /// mm
  Vector point(double u) const;
  /// A unit vector, away from the material.
  Vector normal(double u) const;
  /// |dS/du|, mm, and the curvature of the pass, 1/mm.
  double speed(double u) const;
  double curvature(double u) const;
  /// Where it is nearest to a point.
  double nearest(const Vector& point) const;

  /// The tip at u with the tool along the normal, A tilted to its positive side; C by whole turns nearest to `last_c`.
  TipAndRotary at(double u, double last_c) const;
  /// The same along increasing u.
  std::vector<TipAndRotary> along(const std::vector<double>& places) const;

  /// Where lines end that leave the pass by no more than `chord` mm, as chords of its circle of curvature at the start of
  /// each: Δs = √(8 ρ · chord). From 0 to 1.
  std::vector<double> chords(double chord) const;

  /// Control points of tip and rotary axes as one cubic B-spline of so many equal spans: the tip exactly, by polar forms,
  /// angles by those of their Taylor polynomials of third degree (de Boor and Fix).
  std::vector<TipAndRotary> control_points(int spans) const;

 private:
  const kinematics::Chain& chain_;
};

/// 0 four times, 1/spans, 2/spans, … and 1 four times.
std::vector<double> clamped_knots(int spans);
/// The cubic B-spline with those knots; 0 ≤ u ≤ 1.
TipAndRotary spline_at(const std::vector<TipAndRotary>& control_points, double u);

/// Programs of the pass; feed in mm/s at the tip. `path_control` such as "G61.1".
///
/// Lines of all axes, as machine coordinates; each takes the time that its tip needs (G93).
PartProgram program_of_axes(const kinematics::Chain& chain, const std::vector<TipAndRotary>& ends, double feed,
                            const std::string& path_control);
/// Lines of tip and rotary axes, under tool centre point control.
PartProgram program_of_tip(const kinematics::Chain& chain, const std::vector<TipAndRotary>& ends, double feed,
                           const std::string& path_control);
/// One curve of them (G6.2).
PartProgram program_of_pass(const kinematics::Chain& chain, const std::vector<TipAndRotary>& control_points,
                            double feed);

}  // namespace leadscrew::study
