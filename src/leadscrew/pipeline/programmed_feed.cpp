#include <algorithm>
#include <leadscrew/pipeline/programmed_feed.hpp>
#include <leadscrew/toolpath/feed_length.hpp>

namespace leadscrew::pipeline {

double programmed_feed(const gcode::Move& move) {
  const bool moves = move.kind != gcode::Move::Kind::dwell && move.kind != gcode::Move::Kind::event;
  if (!moves || move.feed.mode == gcode::Feed::Mode::rapid) return 0;
  const bool is_rate = move.feed.mode == gcode::Feed::Mode::per_second;
  return is_rate ? move.feed.value * toolpath::feed_length(move) : move.feed.value;
}

double ProgrammedFeed::at(base::Line line) {
  if (!begun_) has_move_ = moves_(move_);
  begun_ = true;
  while (has_move_ && !base::is_before(line, move_.line)) {
    feed_ = move_.line == line_ ? std::max(feed_, programmed_feed(move_)) : programmed_feed(move_);
    line_ = move_.line;
    has_move_ = moves_(move_);
  }
  return feed_;
}

}  // namespace leadscrew::pipeline
