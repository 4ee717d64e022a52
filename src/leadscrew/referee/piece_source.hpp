#pragma once
// Moves in, pieces out, one at a time.

#include <leadscrew/referee/nurbs.hpp>
#include <leadscrew/referee/piece.hpp>
#include <leadscrew/referee/referee.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace leadscrew::referee {

/// Where motion must rest.
struct RequiredStop {
  Point place{};
  double tolerance = 0;  ///< mm
  base::Line line{};
};

class PieceSource {
 public:
  /// threads_follow: lines of threads and taps, and moves at a feed per revolution, are as fast as a spindle that turns as it
  /// likes, and have no feed.
  PieceSource(MoveSource moves, const Metric& metric, bool threads_follow)
      : moves_(std::move(moves)), metric_(metric), threads_follow_(threads_follow), curve_(metric) {}

  /// The next piece that has a length; false at the program's end.
  bool next(Piece& piece);

  /// Where the program begins, and where the moves read so far end; valid once a move was read.
  bool any_move() const { return block_ > 0; }
  const Point& start() const { return start_; }
  const Point& end() const { return end_; }
  double start_tolerance() const { return start_tolerance_; }  ///< mm; of the first move
  double end_tolerance() const { return end_tolerance_; }      ///< mm; of the last move read
  base::Line end_line() const { return end_line_; }
  double largest_tolerance() const { return largest_tolerance_; }                          ///< mm; of the moves read
  double largest_orientation_tolerance() const { return largest_orientation_tolerance_; }  ///< degrees; likewise
  /// Where motion must rest before the move that comes next, and before those since the last call.
  std::vector<RequiredStop> take_stops() { return std::exchange(stops_, {}); }
  double greatest_feed() const;  ///< mm/s; degrees/s where no linear axis is fed

 private:
  bool read();
  void read_ahead();
  bool next_of_block(Piece& piece);
  void begin(const gcode::Move& move);
  bool begin_arc(const gcode::Move& move);
  bool begin_curve(const gcode::Move& move);
  void begin_line();
  double length_of(const gcode::Move& move, FeedAxes axes) const;
  ProgrammedFeed feed_of(const gcode::Move& move) const;
  void cut_arc(Piece& piece, std::int64_t number) const;

  MoveSource moves_;
  const Metric& metric_;
  const bool threads_follow_;
  bool is_in_step_ = false;  // what follows the move that was read last
  bool has_begun_ = false;
  bool probes_ = false;               // the move that was read last
  std::optional<gcode::Move> ahead_;  // the move behind the block that is being cut
  std::vector<RequiredStop> stops_;
  std::int64_t block_ = 0, serial_ = 0;
  Point start_{}, end_{};
  double start_tolerance_ = 0, end_tolerance_ = 0, largest_tolerance_ = 0;
  double largest_orientation_tolerance_ = 0;
  base::Line end_line_{};
  double greatest_linear_feed_ = 0, greatest_rotary_feed_ = 0;

  // The block that is being cut into pieces.
  Piece whole_;              // of an arc: the block as one, however many turns
  std::int64_t pieces_ = 0;  // it is cut into, unless it is a curve
  std::int64_t next_piece_ = 0;
  double sweep_ = 0;  // of an arc: radians, positive
  Nurbs curve_;
};

}  // namespace leadscrew::referee
