#pragma once
// Cutter compensation (G41, G42, G41.1, G42.1, until G40): the program tells the contour, the tool's middle goes beside it.
//
//     moves as programmed ──▶ kept back until the next motion in the plane is known ──▶ moves of the tool's middle
//
// Where a way ends depends on the corner behind it (offset_contour.hpp), so a motion in the plane waits for the next one,
// and with it, in their order, the events, dwells and moves without motion in the plane that stand between: those happen
// where the way ends. The program's own position is the programmed one throughout, as G91 and centres of arcs count.
//
// As LinuxCNC does it: the first move is a line that is longer than the radius, to beside its own end, or an arc, which
// another takes the place of that ends there in the same direction (Fanuc's family: a line). Behind G40 the tool
// stands where its way has ended until the next line, which leads to where the program says; all the same where compensation
// has been switched on again by then, and first moves are those from where the program stands. Corners at rapid are gone round
// as those at feed are, so that none is cut. L, or Q of the tool table, of a lathe tool, 1 to 9, says where the place that is
// programmed lies from the middle of its radius (LinuxCNC manual, "Lathe tool orientation").
//
// What the tool does not fit into is an error: of each two neighbours on one level at once, beyond them where the contour
// ends or leaves its level (gouge_search.hpp). The ways in and out are not looked at. Where ways meet, and the tool only
// cuts into the contour elsewhere, it is a warning in dialect linuxcnc, which does not look for that, and where gouging is
// allowed. Travel is that of the tool's middle.

#include <deque>
#include <leadscrew/gcode/cutter_radius.hpp>
#include <leadscrew/gcode/gouge_search.hpp>
#include <leadscrew/gcode/offset_contour.hpp>
#include <leadscrew/gcode/travel.hpp>
#include <optional>

namespace leadscrew::gcode {

class CutterCompensation : Part {
 public:
  CutterCompensation(const Context& context, CutterRadius& radius, Travel& travel)
      : Part(context), radius_(radius), travel_(travel) {}

  /// Reports what cannot stand in a block while it is on. Error: `cutter-compensation`.
  void check(const Block& block);
  /// G41 … G42.1. Errors: `cutter-compensation`, and those of CutterRadius.
  void set(const Block& block);
  /// G40: before what else its block changes.
  void end();
  /// Modes come back that were kept (M72), before any other changes. Error: `cutter-compensation`, where it would be switched on.
  bool bring_back(const ModalState& before, const base::AxisVector& tool_length, bool shifts_alike,
                  std::uint32_t column);

  /// Whether moves go through it: while it is on, and until the line behind G40.
  bool is_active() const { return is_on() || is_aside_ || tool_ || !kept_.empty(); }
  /// How far aside of what is programmed the tool's middle goes, mm: to the left, or negative; 0 while it is off.
  double aside() const { return is_on() && phase_ != Phase::passing ? aside_ : 0; }
  /// Whether moves are kept back. Before it ends: settle(), and take() all.
  bool keeps_back() const { return !kept_.empty(); }
  /// Decides what is kept back: no motion in the plane follows it.
  void settle();

  /// A move as programmed, of the block checked last. Errors: `cutter-entry`, `cutter-exit`, `cutter-gouge`, `travel`.
  void add(const Move& move);
  /// Likewise, of a block read before.
  void add(const Move& move, const KeptPlace& place);
  /// The next move of the tool's middle; false where there is none yet.
  bool take(Move& move);
  /// The place of the move taken last, if it is of this line.
  const KeptPlace* place_of(base::Line line) const { return taken_ && taken_->line == line ? &*taken_ : nullptr; }
  /// A block has failed: the program goes on elsewhere.
  void abandon();

 private:
  enum class Phase : std::uint8_t {
    off,
    entering,  ///< on, before the first motion in the plane
    on,
    passing,  ///< on, and moves go through as they are: the radius is 0, or there has been an error
  };
  struct Kept {
    Move move;
    KeptPlace place;
  };

  bool is_on() const { return phase_ != Phase::off; }
  bool refuse(Code code, std::uint32_t column);
  bool allows_groups(const Block& block);
  std::uint32_t groups_before_end(const Block& block) const;
  std::uint32_t groups_within(const Block& block) const;
  bool allows_nonmodal(const Block& block) const;
  bool begin(const Block& block, const Cutter& cutter);
  bool set_origin(const Block& block, const Cutter& cutter);

  bool is_in_plane(const Move& move) const;
  bool is_searched(const Move& move) const;
  bool is_left_to_search(const Move& next, const OffsetPiece& piece) const;
  void let_pass(Kept kept);
  static bool leads_back(const Move& move);
  bool lead_back(const Kept& kept);
  void forget_tool();
  void enter(Kept kept);
  void enter_by_arc(Kept kept);
  void begin_contour(Kept kept, const std::optional<OffsetPiece>& piece);
  void follow(Kept kept);
  bool join(OffsetPiece& next, CornerKind corner);
  void go_round(PlanePoint from, const OffsetPiece& next, const Kept& kept, bool is_level);
  void connect(PlanePoint to, const Kept& kept);
  void decide(Kept kept);
  void finish();
  bool stays_on_level(const Move& next) const;
  void put(Kept& kept, const OffsetPiece& piece);
  void search(const Kept& kept, const OffsetPiece& piece);
  void end_search();
  void check_travel(const Kept& kept);
  void refuse_corner(const KeptPlace& one, const KeptPlace& two);
  void report_gouge(const KeptPlace& one, const KeptPlace& two);
  void warn_of_slight_gouge(const KeptPlace& one, const KeptPlace& two);
  std::string gouge_between(const KeptPlace& one, const KeptPlace& two) const;
  std::string named(const KeptPlace& one, const KeptPlace& two) const;
  double radius() const;
  PlanePoint moved(PlanePoint point) const { return {point.first + origin_.first, point.second + origin_.second}; }
  void set_in_plane(base::AxisVector& place, PlanePoint point) const;

  CutterRadius& radius_;
  Travel& travel_;
  Phase phase_ = Phase::off;
  Plane plane_ = Plane::XY;
  double aside_ = 0;   // mm, to the left
  PlanePoint origin_;  // mm: from the middle of a lathe tool's radius to the place that is programmed
  PlanePoint at_;      // mm: where the moves decided so far have led
  // Behind G40 the tool is beside where the program stands: until a line has been added, and where, until that is taken.
  bool is_aside_ = false;
  std::optional<base::AxisVector> tool_;
  std::uint32_t column_ = 1;  // of the block checked last
  std::deque<Kept> kept_;     // in their order; the first decided_ of them can be taken
  std::size_t decided_ = 0;
  std::optional<OffsetPiece> piece_;  // of kept_[decided_], which waits for the next; what is behind it waits with it
  bool is_entry_ = false;             // that is the way in
  // Of the motion before, where it is on the same level.
  std::optional<ContourPiece> contour_;
  KeptPlace contour_place_;
  GougeSearch search_;
  std::optional<KeptPlace> taken_;
};

}  // namespace leadscrew::gcode
