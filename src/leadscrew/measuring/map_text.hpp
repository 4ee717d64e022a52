#pragma once
// What is left at all places of the grid, as comma-separated rows:
//
//     line,u,v,x,y,z,height    line: of the block that machines the surface; mm, height along n, 0 where the tool touched, below 0
//                              where it cut; empty where it was not reached
//
// in the order of u, then v, by surfaces. Twelve significant digits.

#include <leadscrew/base/block_sink.hpp>
#include <leadscrew/base/line.hpp>
#include <leadscrew/measuring/measurement.hpp>

namespace leadscrew::measuring {

class MapText {
 public:
  explicit MapText(base::ByteSink sink);
  /// All places of a finished measurement. Errors: those of the sink.
  base::Result<void> write(const Measurement& measurement, base::Line line);
  base::Result<void> finish() { return rows_.flush(); }

 private:
  base::BlockSink rows_;
};

}  // namespace leadscrew::measuring
