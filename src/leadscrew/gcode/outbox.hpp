#pragma once
// The moves and events that one block has made, until they are taken.

#include <deque>
#include <leadscrew/gcode/part.hpp>

namespace leadscrew::gcode {

class Outbox : Part {
 public:
  explicit Outbox(const Context& context) : Part(context) {}

  /// Forgets what was not taken.
  void clear() { size_ = next_ = 0; }

  /// Adds a move of no length from where the program stands, which takes no time.
  Move& emit(Move::Kind kind);
  void emit_event(base::Event::Kind kind, double value = 0, std::int32_t output = 0, double q = 0);

  /// Makes of a move an event where the program stands.
  void prepare_event(Move& move, base::Event::Kind kind, double value = 0, std::int32_t output = 0, double q = 0) const;

  /// The move that was added first of those not yet taken; false where there is none.
  bool take(Move& move);

  /// Makes of a move what emit() adds, of a line of the text. Field by field, in the memory of the move before: this is
  /// done once a block.
  void prepare(Move& move, Move::Kind kind, base::Line line) const {
    move.kind = kind;
    move.path_mode = modal_.effective_mode;
    move.plane = modal_.plane;
    move.probes = ProbeSearch::nothing;
    move.line = line;
    move.start = frame_.position;
    move.end = frame_.position;
    move.feed = {};
    move.tolerance = modal_.effective_tolerance;
    move.naive_cam_tolerance = modal_.effective_naive_cam_tolerance;
    move.center_first = move.center_second = 0;
    move.turns = 0;
    move.curve.clear();
    move.is_of_tip = false;
    set_tool(move);
    move.dwell_seconds = 0;
    move.event = {};
  }

 private:
  bool waits_for(base::Event::Kind kind) const;
  void set_tool(Move& move) const;

  std::deque<Move> moves_;  ///< those not used are kept for their memory
  std::size_t size_ = 0;
  std::size_t next_ = 0;
};

}  // namespace leadscrew::gcode
