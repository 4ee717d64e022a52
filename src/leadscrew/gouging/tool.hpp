#pragma once
// A tool as a body, and where it is: parts one above the other, each round about the tool's axis.
//
//        │       │      holder     from the tool's length on
//        └─┐   ┌─┘
//          │   │        shank      where the cutting edges end before
//          │   │
//         ┌┘   └┐
//         │     │       cutter     R, corner r
//         ╰─────╯
//            •  tip
//
// Each part is taken as it is from below and from the side: nothing comes upon it from above.

#include <array>
#include <cstdint>
#include <leadscrew/surfaces/cutter.hpp>
#include <limits>

namespace leadscrew::gouging {

using surfaces::Vector;

/// One part: all within `radius` of the axis, from `bottom` to `top`, its lower edge rounded.
struct Part {
  enum class Kind : std::uint8_t { cutter, shank, holder };

  Kind kind = Kind::cutter;
  double radius = 0;                                     ///< R, mm; > 0
  double corner = 0;                                     ///< r of the lower edge, mm; 0 … R; R: a ball
  double bottom = 0;                                     ///< above the tip, mm
  double top = std::numeric_limits<double>::infinity();  ///< above the tip, mm; > bottom
};

/// What is known of a tool. What is not known is 0.
struct ToolForm {
  surfaces::Cutter cutter;
  double edge_length = 0;    ///< of the cutting edges, above the tip, mm; 0: up to the holder
  double shank_radius = 0;   ///< above the edges, mm; 0: as the cutter
  double length = 0;         ///< from the tip to the holder, mm; 0: without end, and there is no holder
  double holder_radius = 0;  ///< mm; 0: no holder
  double holder_length = 0;  ///< mm; 0: without end
};

/// Its parts: one to three.
class Tool {
 public:
  explicit Tool(const ToolForm& form);

  const Part* begin() const { return parts_.data(); }
  const Part* end() const { return parts_.data() + count_; }
  std::size_t size() const { return count_; }

 private:
  std::array<Part, 3> parts_{};
  std::size_t count_ = 0;
};

/// Where a tool is.
struct Pose {
  Vector tip{};             ///< mm
  Vector axis = {0, 0, 1};  ///< from the tip to the spindle, a unit vector
};

}  // namespace leadscrew::gouging
