#pragma once
// Fragments of part programs, and the least time in which each can be travelled inside its tube.

#include <leadscrew/study/blended_programs.hpp>
#include <span>

namespace leadscrew::study {

/// From machine zero, within 0.01 mm at 100 mm/s, on the built-in mill.
struct TubeFragment {
  std::string_view file;  ///< name of its files, without extension
  BlendedProgram program;
  double least = 0;  ///< s; found by least_time_motion, the least of five starts far apart
};

inline constexpr double least_accuracy = 0.001;  ///< of `least`, relative: what starts and knots make of it

std::span<const TubeFragment> tube_fragments();

}  // namespace leadscrew::study
