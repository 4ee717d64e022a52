#pragma once
// A surface as one block, and the same passes over it as an off-line program has them, in short lines.
//
// The patch is a bicubic Bézier surface whose control points stand 20 mm apart in x and y. A ball of 5 mm radius, upright,
// leaves ridges of 0.01 mm in passes along u, there and back.

#include <leadscrew/study/curves.hpp>
#include <leadscrew/surfaces/passes.hpp>
#include <vector>

namespace leadscrew::study {

using surfaces::Vector;

inline constexpr double ball_radius = 5, ridge_height = 0.01;  // mm

surfaces::SurfaceForm patch_form();
/// equal_steps: all steps alike, by the place that needs the least.
surfaces::Machining patch_machining(bool equal_steps = false);

/// Passes and links in their order.
std::vector<surfaces::Pass> patch_passes(bool equal_steps = false);

/// Of a pass or link at its parameter, mm. contact: where the tool touches, of passes alone.
enum class Of : std::uint8_t { tip, contact };
Vector place_of(const surfaces::Pass& pass, double t, Of of = Of::tip);
/// mm
double length_of(const surfaces::Pass& pass, Of of);

/// Passes and links as lines that leave the tip's path by no more than a tolerance, each as long as may be.
struct LinesOfPasses {
  double chord = 0;           ///< mm
  std::vector<Vector> ends;   ///< mm; the beginning of the first pass is the first
  std::size_t of_passes = 0;  ///< how many lines are of passes; the others are of links
};
LinesOfPasses lines_of(const std::vector<surfaces::Pass>& passes, double chord);

/// The height above the surface, along its normal, of what two neighbouring passes leave, the greatest of `sections` across
/// them, mm: of the tool as it sweeps along, not of its section.
double ridge_between(const surfaces::Surface& surface, const surfaces::Pass& a, const surfaces::Pass& b, int sections);

/// How far the surface of a ball is from touching, mm: its centre's distance from the patch less the radius.
double contact_error(const surfaces::Surface& surface, const Vector& tip);

/// Least and greatest error of feed, per cent, where u goes on by VT/|C′|, and by the second term of its Taylor series, along
/// v = 0.5 of the patch: distance from word to word over VT. feed: mm/s, period: s.
struct FeedErrors {
  double least = 0, most = 0;
};
FeedErrors feed_errors(int order, double feed, double period);

/// Programs that machine the patch; feed in mm/s at the tip. Both begin 25 mm high over the origin, come down over the first
/// place, and rise to there in the end.
PartProgram surface_program(double feed);
PartProgram lines_program(const LinesOfPasses& lines, double feed, const std::string& path_control);
/// The definition and the block alone.
std::string surface_blocks(double feed);
/// The same patch by a bull nose of 5 and 1 mm that leans eight degrees ahead, by the five axes of trunnion(): ridges of 0.1 mm.
PartProgram leaning_program(double feed);

}  // namespace leadscrew::study
