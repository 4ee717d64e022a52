#pragma once
// LinuxCNC's lathe cycles (LinuxCNC manual, G Codes, "G70", "G71 G72"), and those of Fanuc's lathes, whose contours are
// blocks of the program (Fanuc 0i operator's manual, "Multiple Repetitive Cycle"). The block of the cycle is followed by the
// subprogram of its number Q, whose blocks make no moves but a contour: G0 to G3, and A and C, fillets and chamfers at
// their ends. Where the subprogram ends, the cycle is planned and its moves are handed out.

#include <leadscrew/gcode/motion.hpp>
#include <leadscrew/gcode/roughing.hpp>
#include <limits>
#include <optional>

namespace leadscrew::gcode {

class LatheCycles : Part {
 public:
  static constexpr std::size_t most_pieces = 1000;  ///< of a contour

  LatheCycles(const Context& context, Motion& motion, Travel& travel)
      : Part(context), motion_(motion), travel_(travel) {}

  /// The block of a cycle: goes to where the cycle starts.
  [[gnu::cold]] void begin(const Block& block);
  /// G70 to G73 of Fanuc's lathes (profile_cycles.cpp): the contour is blocks P to Q of the program. A block without them
  /// says how deep cuts are.
  [[gnu::cold]] void begin_profile(const Block& block);
  /// Whether the cycle is one of those.
  bool is_profile() const {
    const Code code = block_.code(Group::nonmodal);
    return Code::G70_profile <= code && code <= Code::G73_profile;
  }
  /// From the block of a cycle to the end of its contour.
  bool is_open() const { return is_open_; }
  /// The block of the cycle.
  const Block& block() const { return block_; }
  /// A block of the contour.
  [[gnu::cold]] void add(const Block& block);
  /// The subprogram has ended.
  [[gnu::cold]] void end();

  /// G41 or G42 with which the contour of G70 begins: holds from the cycle's first move on.
  struct Compensation {
    Block block;
    KeptPlace place;
  };
  const std::optional<Compensation>& compensation() const { return compensation_; }
  /// Compensation ends in the contour of G70 or behind it: before a move that is yet to come, before the next one.
  bool will_end_compensation() const { return compensated_ != all; }
  bool ends_compensation() const { return compensated_ == next_; }
  void compensation_has_ended() { compensated_ = all; }
  /// The cycle has been planned, and compensation by so many mm to the left is on. Warning: `cutter-return`, where the way back
  /// of G70 turns back on the tool's side, so that the contour's last piece is not cut to its end.
  [[gnu::cold]] void check_way_back(double aside);
  /// The block that the move taken last is of, where it is one of G70; else null.
  const KeptPlace* place_of(const Move& move) const;

  /// The next move of the cycle in execution; false where there is none, or no more.
  bool next(Move& move, const Outbox& outbox) { return next_ < moves_.size() && take(move, outbox); }
  /// The cycle is not followed: the program stands where it would have ended.
  void abandon();

 private:
  /// A move in machine coordinates, mm.
  struct Planned {
    bool rapid = false;
    int turn = 0;
    PlanePoint end, center;
    std::uint32_t block = 0;  // of feeds_
  };
  /// What blocks of Fanuc's G71 to G73 without P and Q say, mm.
  struct ProfileSettings {
    double depth = 2;       ///< G71, G72: of a cut
    double retract = 0.5;   ///< G71, G72: how far the tool leaves the cut
    PlanePoint farthest{};  ///< G73: how far off the contour it begins, X a radius
    int passes = 2;         ///< G73
  };

  /// G40 of a contour that is compensated.
  struct CompensationEnd {
    KeptPlace place;
    std::uint32_t block = 0;  // the first whose moves are not compensated
  };
  static constexpr std::size_t all = std::numeric_limits<std::size_t>::max();

  bool check_words(const Block& block);
  bool check_turning(const Block& block);
  void keep_settings(const Block& block);
  void note_feed(const Block& block, ContourPiece& piece);
  void note_compensation(const Block& block, bool moves);
  void begin_compensation(const Block& block);
  bool place_profile(const std::vector<LatheMove>& moves);
  bool are_inside_uncompensated();
  static PlanePoint direction_of(const Planned& move, PlanePoint start);
  std::vector<LatheMove> plan_profile();
  bool plan_profile_roughing(std::vector<LatheMove>& moves);
  bool plan_profile_passes(std::vector<LatheMove>& moves);
  PlanePoint target_of(const Block& block);
  bool add_arc(const Block& block, ContourPiece& piece);
  void add_corner(const Block& block);
  bool is_finishing() const { return block_.is(Code::G70); }
  bool is_along_x() const;
  bool goes_along_z() const;
  Pockets pockets() const;
  std::vector<LatheMove> plan();
  std::vector<LatheMove> plan_roughing(Attitude& attitude);
  std::vector<LatheMove> plan_finishing(Attitude& attitude);
  bool prepare(Attitude& attitude, bool turned, Contour& contour) const;
  static bool offset_to_start(Contour& contour, PlanePoint start, double aside);
  bool place(const std::vector<LatheMove>& moves);
  bool is_inside(const Planned& move, PlanePoint start);
  bool refuse(std::string_view code, std::string message, std::string hint);
  bool take(Move& move, const Outbox& outbox);

  Motion& motion_;
  Travel& travel_;
  Block block_;  // of the cycle
  base::Line line_{};
  Feed feed_;
  std::vector<Feed> feeds_;  // of the contour's blocks, where these have feeds of their own
  double feed_speed_ = 0;    // of the spindle, at which feeds of a revolution were read; revolutions per minute
  ProfileSettings settings_;
  bool is_open_ = false;
  std::int64_t errors_before_ = 0;
  Code motion_code_ = Code::G0;  // in force in the contour
  PlanePoint start_, position_;  // of the cycle, and where the contour has come to; the program's units
  Contour contour_;
  std::vector<ContourCorner> corners_;
  std::vector<Planned> moves_;
  std::size_t next_ = 0;
  std::vector<KeptPlace> places_;  // of feeds_, of G70
  std::optional<Compensation> compensation_;
  std::optional<CompensationEnd> compensation_end_;
  std::size_t compensated_ = all;  // so many moves, where what follows them is not
};

}  // namespace leadscrew::gcode
