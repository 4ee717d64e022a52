#pragma once
// How far a tool is from a surface, anywhere: for links, which no tensor tells of.
//
// The tool is a body of revolution that goes on upwards without end: with a the height of a point above the tip along the axis
// and ρ its distance from the axis, it is as far from the tool as a rounded box is (Quilez, "distance functions"):
//
//     q = (ρ − (R − r), r − a)       d = |max(q, 0)| + min(max(q₁, q₂), 0) − r
//
// d changes by no more than a point moves. Points of the whole surface, in blocks with a sphere about each and blocks in groups with one more,
// tell about where it is least; Newton's method goes on from there.

#include <leadscrew/surfaces/cutter.hpp>
#include <leadscrew/surfaces/surface.hpp>
#include <vector>

namespace leadscrew::surfaces {

/// A tool somewhere: its tip, mm, and axis, a unit vector.
struct ToolPose {
  Vector tip{}, axis{};
};

/// Of a point from the tool; below 0 inside. mm
double distance_from_tool(const Cutter& cutter, const ToolPose& pose, const Vector& point);

class ToolClearance {
 public:
  ToolClearance(const Surface& surface, const Cutter& cutter);

  struct Place {
    double distance = 0;  ///< mm, below 0 where the tool is in the surface
    double u = 0, v = 0;
  };
  /// The least over the surface. `near`: a place to look at first. No more than `enough` need be told exactly: what is farther is
  /// farther.
  Place least(const ToolPose& pose, const Place& near, double enough) const;

 private:
  /// A sphere about some points, or about some blocks' points.
  struct Block {
    Vector centre{};
    double radius = 0;
    std::size_t first = 0, last = 0;
  };
  struct Point {
    Vector position{};
    double u = 0, v = 0;
  };
  void add_group(const std::array<std::vector<double>, 2>& places, std::size_t i, std::size_t j);
  Block around(std::size_t first, std::size_t last) const;
  Place refined(const ToolPose& pose, Place place) const;

  const Surface& surface_;
  Cutter cutter_;
  std::vector<Point> points_;
  std::vector<Block> blocks_, groups_;
};

}  // namespace leadscrew::surfaces
