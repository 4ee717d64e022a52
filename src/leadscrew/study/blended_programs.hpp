#pragma once
// Part programs of short lines and corners, as CAM systems write them, to be blended within a tolerance (G64 P).

#include <leadscrew/study/motion.hpp>
#include <leadscrew/study/row.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace leadscrew::study {

/// Blocks of lines and arcs, and where they begin.
struct ProgrammedContour {
  std::string blocks;
  base::AxisVector start{};  ///< machine coordinates, mm
};

struct BlendedProgram {
  std::string_view name;
  ProgrammedContour (*contour)();
  double feed = 0;             ///< mm/s
  double tolerance = 0;        ///< mm
  std::optional<double> most;  ///< s that the motion may take; without it, what it takes with a stop at each joint
  std::string_view why = {};   ///< of `most`
  std::optional<machine::AxisLimits> a = {};  ///< of the axis A, where it moves
  double deviation = tolerance;               ///< mm that the words may be off
};

std::span<const BlendedProgram> blended_programs();

/// Of them, the plane cubic as 92 lines, at a feed of its own, mm/s.
BlendedProgram cubic_as_lines(double feed);

/// In G64 with the program's tolerance.
PartProgram blended(const BlendedProgram& program);
/// In G61.1.
PartProgram stopping(const BlendedProgram& program);

/// The built-in mill with v 200 mm/s, a 1000 mm/s², j 20000 mm/s³, and the A of the program.
machine::Machine machine_of(const BlendedProgram& program, base::Period period);

/// "square of 10 mm, P 0.01 mm, F 100 mm/s, a 1000 mm/s², j 20000 mm/s³"
std::string circumstances(const BlendedProgram& program);

/// Time, limits, deviation and effort of its motion.
Rows blended_rows(const BlendedProgram& program, const Host& host);

}  // namespace leadscrew::study
