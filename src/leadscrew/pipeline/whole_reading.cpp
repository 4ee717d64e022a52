#include <leadscrew/pipeline/feed_check.hpp>
#include <leadscrew/pipeline/whole_reading.hpp>

namespace leadscrew::pipeline {

namespace {

bool is_path(const gcode::Move& move) {
  return move.kind != gcode::Move::Kind::dwell && move.kind != gcode::Move::Kind::event;
}

bool is_pause(const gcode::Move& move) {
  return move.kind == gcode::Move::Kind::event && base::is_pause(move.event.kind);
}

}  // namespace

ReadProgram read_whole(gcode::Reader& reader, const ReadingWatch& watch) {
  ReadProgram read;
  gcode::Move move;
  for (std::int64_t count = 1; !read.was_interrupted && reader.next(move); ++count) {
    if (watch.survey != nullptr && watch.is_sound()) {
      if (const auto excess = watch.survey->observe(move)) reader.warn_of_feed(move, warning_of(*excess));
    }
    if (watch.see) watch.see(move);
    read.moves += is_path(move) ? 1 : 0;
    read.pauses += is_pause(move) ? 1 : 0;
    read.was_interrupted = count % watch.moves_between_questions == 0 && watch.goes_on && !watch.goes_on();
  }
  read.blocks = reader.blocks();
  return read;
}

}  // namespace leadscrew::pipeline
