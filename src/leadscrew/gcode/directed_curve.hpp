#pragma once
// G6.6: a smooth curve in space, with the tool's direction along it.
//
//     G6.6 P20 F2000          through the places of the next 20 blocks, from where the tool stands
//     X_ Y_ Z_ I_ J_ K_       a place of the tip, and the direction from there to the spindle, of any length. Coordinates and a direction
//                             that are not given keep their value.
//
// The tip goes along the cubic spline through all places, the tool's direction along that through the directions, made unit
// vectors: both have continuous curvature, by a parameter that is the distance from place to place. Directions need tool centre point
// control; without any the rotary axes stand. Axes keep to the solution by which they hold the tool where the curve begins. It ends with its
// last place; until then there is nothing else.

#include <leadscrew/gcode/motion.hpp>
#include <leadscrew/gcode/pose_moves.hpp>
#include <optional>
#include <vector>

namespace leadscrew::gcode {

class DirectedCurve : Part {
 public:
  DirectedCurve(const Context& context, Motion& motion, Travel& travel, Outbox& outbox)
      : Part(context), motion_(motion), curves_(context, travel, outbox) {}

  /// G6.6. Errors: `surface-counts`, `bad-feed-mode`.
  [[gnu::cold]] void begin(const Block& block);
  /// From that block to the last place.
  bool is_open() const { return draft_.has_value(); }
  /// A block of the curve; false where it is none, which ends the curve. Errors: `missing-word`, `curve-place`, `tool-vector`,
  /// `surface-needs-tip-control`, `unfinished-curve`, `surface-pole`, `pose-out-of-reach`.
  [[gnu::cold]] bool add(const Block& block);
  /// Where the text ends.
  [[gnu::cold]] void end();

  bool is_active() const { return curves_.path().any(); }
  /// The next move; false where there is none, or no more. Error: `travel`.
  [[gnu::cold]] bool next(Move& move);
  [[gnu::cold]] void abandon() { curves_.path().clear(); }

 private:
  /// Once a problem of it has been reported, it is only followed to its end.
  struct Draft {
    std::size_t count = 0;  // of blocks; 0: not known
    Block block;            // G6.6
    KeptPlace place;
    std::vector<base::AxisVector> places;  // of the tip; machine coordinates, mm
    std::vector<surfaces::Vector> directions;
    std::size_t blocks = 0;
    bool turns = false;  // a block tells a direction
    bool spoiled = false;
  };

  void add_place(const Block& block);
  bool problem(std::string_view code, std::uint32_t column, std::string message, std::string hint);
  std::optional<surfaces::Vector> direction_of(const Block& block);
  void finish();
  surfaces::Pass nodes_of(const Draft& draft) const;
  void hold_tool();

  Motion& motion_;
  PoseMoves curves_;
  std::optional<Draft> draft_;
  Block block_;
  KeptPlace place_;  // of it
  Feed feed_;
};

}  // namespace leadscrew::gcode
