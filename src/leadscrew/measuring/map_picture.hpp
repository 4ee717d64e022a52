#pragma once
// What is left of a surface, as a picture: the range of its parameters in colours, and a section across the passes through the
// tallest ridge.

#include <leadscrew/base/sink.hpp>
#include <leadscrew/measuring/measurement.hpp>
#include <string>
#include <vector>

namespace leadscrew::measuring {

/// One surface of a picture.
struct Pictured {
  std::string title;
  const Measurement* measurement = nullptr;
  double scallop = 0;      ///< mm asked for, drawn dashed; 0: none was
  double allowed_cut = 0;  ///< mm; ≥ 0
};

/// SVG, one surface below the other. Errors: those of the sink.
base::Result<void> write_map_svg(const std::string& title, const std::vector<Pictured>& surfaces,
                                 const base::ByteSink& sink);

}  // namespace leadscrew::measuring
