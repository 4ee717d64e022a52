#pragma once
// The surfaces that a program machines, where they lie in the workpiece as it is with all rotary axes at 0.

#include <leadscrew/gcode/frame.hpp>
#include <leadscrew/gcode/machined.hpp>
#include <leadscrew/gouging/move_ways.hpp>
#include <memory>
#include <vector>

namespace leadscrew::gouging {

/// Those that differ in shape or place, in the order in which they come.
class MachinedSurfaces {
 public:
  explicit MachinedSurfaces(const MovePoses& poses) : poses_(poses) {}

  /// `frame` is that of the block. The surface in the workpiece; null where there are too many.
  std::shared_ptr<const surfaces::Surface> add(const gcode::Machined& machined, const gcode::Frame& frame);

  const std::vector<std::shared_ptr<const surfaces::Surface>>& all() const { return surfaces_; }
  /// D of one.
  int number(std::size_t surface) const { return numbers_[surface]; }

 private:
  const MovePoses& poses_;
  std::vector<std::shared_ptr<const surfaces::Surface>> surfaces_;
  std::vector<int> numbers_;
};

}  // namespace leadscrew::gouging
