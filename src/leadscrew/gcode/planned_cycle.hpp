#pragma once
// The moves of a cycle that is planned as a whole: lines, and arcs in the plane XY, said in the program's coordinates and
// kept in those of the machine until they are taken. Each is checked against the axes' travel as it is added.

#include <leadscrew/gcode/motion.hpp>

namespace leadscrew::gcode {

class PlannedCycle : Part {
 public:
  static constexpr std::size_t most_moves = 200'000;  ///< of one cycle

  PlannedCycle(const Context& context, Travel& travel, Outbox& outbox)
      : Part(context), travel_(travel), outbox_(outbox) {}

  /// A cycle of this block begins where the program stands; from beside a contour a move at rapid leads there first. The
  /// block must outlive the calls that add moves.
  [[gnu::cold]] void begin(const Block& block);
  /// The same of a block before, whose place the reporter has kept: problems are told there.
  [[gnu::cold]] void begin_kept(const Block& block);
  /// Where the moves so far lead: X, Y and Z of the program, mm.
  const std::array<double, 3>& position() const { return position_; }
  PlanePoint place() const { return {position_[0], position_[1]}; }

  // Add a move, mm; at rapid where the feed is of that mode. What cannot be moved is reported, and then nothing of the
  // cycle is.
  void line(PlanePoint to, const Feed& feed) { line({to.first, to.second, position_[2]}, feed); }
  void level(double z, const Feed& feed) { line({position_[0], position_[1], z}, feed); }
  void line(const std::array<double, 3>& to, const Feed& feed);
  /// An arc of up to one turn about a centre, a whole one where its ends coincide; `turn`: 1 counterclockwise, −1
  /// clockwise. Its ends may differ in their distance from the centre by rounding alone.
  void arc(PlanePoint to, PlanePoint center, int turn, const Feed& feed);
  /// Nothing more can be added: there has been an error.
  bool failed() const { return failed_; }

  /// The next move of the cycle in execution; false where there is none, or no more.
  bool next(Move& move) { return next_ < moves_.size() && take(move); }
  /// The cycle is not followed: the program stands where it would have ended.
  void abandon();

 private:
  struct Planned {
    int turn = 0;  // of an arc
    std::array<double, 3> end{};
    PlanePoint center;
    Feed feed;
  };

  void fail(std::string_view code, std::string message, std::string hint);
  bool is_inside(const base::AxisVector& low, const base::AxisVector& high);
  bool has_room();
  base::AxisVector placed(const std::array<double, 3>& place) const;
  void add(const base::AxisVector& end, int turn, PlanePoint center, const Feed& feed);
  [[gnu::cold]] bool take(Move& move);

  Travel& travel_;
  Outbox& outbox_;
  const Block* block_ = nullptr;
  base::AxisVector start_{};  // of the cycle; the program's coordinates
  base::AxisVector end_{};    // of the moves so far; the machine's
  std::array<double, 3> position_{};
  std::vector<Planned> moves_;
  std::size_t next_ = 0;
  bool failed_ = false;
  bool is_kept_ = false;
};

}  // namespace leadscrew::gcode
