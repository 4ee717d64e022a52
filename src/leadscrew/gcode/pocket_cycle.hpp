#pragma once
// G150: a pocket of any simple contour (Haas mill operator's manual, "General Purpose Pocket Milling"). The block is
// followed by the subprogram of its number P: a move from the hole at X Y, where the tool goes in, to the contour, and the
// contour, which is closed. Where the subprogram ends, the cycle is planned and its moves are handed out.
//
//      rapid to X Y and R · for each level, Q deeper: down at feed, lines at steps of I or J, along the contour
//      at K and the tool's radius from it · at Z along the contour at the tool's radius, where K is left · up
//
// No move brings the tool's middle nearer to the contour than its radius: what cannot be proven to keep that distance is
// refused.

#include <leadscrew/gcode/cutter_radius.hpp>
#include <leadscrew/gcode/planned_cycle.hpp>
#include <leadscrew/gcode/pocket_path.hpp>

namespace leadscrew::gcode {

class PocketCycle : Part {
 public:
  static constexpr std::size_t most_pieces = 1000;  ///< of a contour

  PocketCycle(const Context& context, Motion& motion, CutterRadius& cutter, PlannedCycle& cycle)
      : Part(context), motion_(motion), cutter_(cutter), cycle_(cycle) {}

  [[gnu::cold]] void begin(const Block& block);
  /// From the block of the cycle to the end of its subprogram.
  bool is_open() const { return is_open_; }
  /// The block of the cycle.
  const Block& block() const { return block_; }
  /// A block of the contour.
  [[gnu::cold]] void add(const Block& block);
  /// The subprogram has ended.
  [[gnu::cold]] void end();
  void abandon() { is_open_ = false; }

 private:
  /// mm.
  struct Plan {
    double cutter = 0;  ///< radius, as a length of the program
    double step = 0;    ///< > 0
    bool steps_along_x = false;
    double allowance = 0;  ///< K ≥ 0
    double depth = 0;      ///< Q of a level; 0: all at once
    double top = 0;        ///< R
    double bottom = 0;     ///< Z ≤ R
    PlanePoint hole;
  };

  bool check_place(const Block& block);
  bool plan(const Block& block);
  bool plan_levels(const Block& block);
  bool add_arc(const Block& block, ContourPiece& piece);
  bool refuse(std::string message, std::string hint);
  bool close_contour();
  bool find_path(double aside, std::vector<PlanePoint>& path);
  bool offset_contours();
  void mill(const std::vector<PlanePoint>& path);
  bool go_to(const Contour& contour, std::size_t& piece);
  void go_round(const Contour& contour, std::size_t piece);
  void cut(const ContourPiece& piece, PlanePoint to);

  Motion& motion_;
  CutterRadius& cutter_;
  PlannedCycle& cycle_;
  Block block_;
  base::Line line_{};
  Feed feed_;
  Plan plan_;
  bool is_open_ = false;
  std::int64_t errors_before_ = 0;
  // Of the contour: what holds where it has come to.
  Code motion_code_ = Code::G1;
  Distance distance_ = Distance::absolute;
  PlanePoint position_;
  Contour contour_;
  Contour outline_, finish_;  // at the allowance, and at none; none where the tool does not go there
};

}  // namespace leadscrew::gcode
