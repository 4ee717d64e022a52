#pragma once
// How a pocket is cleared: back and forth along X, line by line, each a step beside the last. The lines are divided where
// the region is interrupted; the tool goes from part to part where they lie side by side and what is between them is
// clear, and back the same way, so that it never leaves the region and is never lifted.

#include <leadscrew/gcode/pocket_region.hpp>

namespace leadscrew::gcode {

class PocketPath {
 public:
  /// The region at least `aside` inside the contour, from a place in it, in steps along Y. All > 0 but aside, which may
  /// be 0. The contour must outlive this.
  PocketPath(const Contour& contour, double aside, PlanePoint start, double step);

  enum class Outcome : std::uint8_t {
    planned,
    outside,      ///< the start is not in the region
    interrupted,  ///< parts of the region cannot be reached from it
    too_many,     ///< lines, or pieces of the contour
  };
  /// Where the tool goes from the start on.
  std::vector<PlanePoint> points();
  Outcome outcome() const { return outcome_; }

 private:
  struct Part {
    Span span;
    double y = 0;
    bool is_cut = false;
    std::vector<std::size_t> neighbours;
  };

  bool find_parts();
  bool find_link(const Part& from, const Part& to, double near, double& x) const;
  bool is_clear(PlanePoint from, PlanePoint to) const;
  void go(PlanePoint to);
  void cut(Part& part);

  const Contour& contour_;
  double aside_;
  PlanePoint start_;
  double step_;
  std::vector<Part> parts_;
  std::vector<PlanePoint> points_;
  PlanePoint tool_;
  Outcome outcome_ = Outcome::planned;
};

}  // namespace leadscrew::gcode
