#pragma once
// How a lathe roughing cycle (LinuxCNC manual, G Codes, "G71 G72") cuts down to a contour, in the attitude in which Z
// decreases along it and X grows from its first point to its last.
//
//      start ●──────────────────────────▶ ╮ back at rapid, R away from the cut
//            │ ◀─ depth I               ╭─╯
//            ├────────────────────▶ ╭───╯
//            ├────────────▶ ╭───────╯            at last along the contour, to its end; a pocket on the way
//            ╰──────────────╯                    is cleared level by level where the contour falls into it

#include <cstdint>
#include <leadscrew/gcode/contour.hpp>

namespace leadscrew::gcode {

/// What is done about pockets: places where the contour falls.
enum class Pockets : std::uint8_t {
  cut,   ///< as they come: G71, G72
  pass,  ///< they are passed over: G71.1, G72.1
  only,  ///< nothing before the first of them is cut: G71.2, G72.2
};

/// A move of a lathe cycle: a line at rapid or at feed, or an arc at feed.
struct LatheMove {
  bool rapid = false;
  int turn = 0;  ///< of an arc, as in ContourPiece
  PlanePoint end;
  PlanePoint center;
  std::uint32_t block = 0;  ///< of the contour, whose feed it has
};

inline constexpr std::size_t most_lathe_moves = 200'000;

/// How cuts follow each other.
enum class CutOrder : std::uint8_t {
  linuxcnc,  ///< the first at the level of the start, and each begins where it comes down along the contour
  fanuc,     ///< the first one depth below the start, and the tool comes back straight, above the cut
};

class Roughing {
 public:
  /// The first piece of the contour leads to it from where the tool starts. 0 < depth of a cut; 0 ≤ retract.
  Roughing(const Contour& contour, double depth, double retract, Pockets pockets, CutOrder order = CutOrder::linuxcnc);

  /// How that went.
  enum class Outcome : std::uint8_t {
    planned,
    too_many,  ///< there would be more than most_lathe_moves
    open,      ///< nothing ends a cut
  };

  /// All moves, from the start on; none where they cannot be planned.
  std::vector<LatheMove> moves();
  Outcome outcome() const { return outcome_; }

 private:
  void line(PlanePoint end, bool rapid = false);
  void along(std::size_t i, PlanePoint end, bool rapid = false);
  bool falls(std::size_t i) const;
  void descend();
  void skip_first_fall();
  void follow_to_pocket();
  void enter_pocket();
  void pass_over_pockets();
  bool cut();
  void cut_to(PlanePoint end);
  static bool crossing(const ContourPiece& piece, double level, double& z);

  Contour contour_;
  double depth_, retract_;
  Pockets pockets_;
  CutOrder order_;
  std::vector<LatheMove> moves_;
  PlanePoint tool_;
  std::size_t at_ = 0;      // piece
  double level_ = 0;        // X of the next cut
  double start_level_ = 0;  // from which levels count
  bool in_pocket_ = false;  // Pockets::only: levels count from the top of a pocket
  double pocket_level_ = 0;
  Outcome outcome_ = Outcome::planned;
};

}  // namespace leadscrew::gcode
