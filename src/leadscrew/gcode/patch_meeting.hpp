#pragma once
// Where a line first meets the patches that the simulated probe touches (machine::ProbePatch).
//
//     the net seen along the line:        a patch is within the hull of its net. A hull that the line misses, or that lies
//         o───o───o                       nowhere between the line's ends, is done with; the others are halved, the nearest
//         │  ·│   │    · the line         first, until what is left is a box of 2e-10 mm. Nothing is tessellated: a patch that
//         o───o───o                       the line meets is never missed.
//
// A hull is seen along two directions across the line, and a third that is across the patch as well: without that one
// many small cells beside a patch that the line goes along would be kept.

#include <leadscrew/machine/probe.hpp>
#include <optional>
#include <vector>

namespace leadscrew::gcode {

/// The share, 0 … 1, of the line from `from` to `to`, mm, at which it first is within 1e-10 mm of a patch; right to 2e-10 mm of
/// its length. Empty where it meets none, or has no length. A line that goes beside a patch, at less than a micrometre for
/// millimetres, may be said to meet it where that begins.
std::optional<double> first_meeting(const std::vector<machine::ProbePatch>& patches, const machine::Vector& from,
                                    const machine::Vector& to);

/// Is a patch within a distance of the point, mm; up to √3 times as far it may be said to be.
bool is_near_patch(const std::vector<machine::ProbePatch>& patches, const machine::Vector& point, double distance);

}  // namespace leadscrew::gcode
