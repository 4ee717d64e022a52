// Contours of lathe cycles that are blocks of the program (Fanuc 0i operator's manual, "Multiple Repetitive Cycle"): they
// are read as the cycle is met. Behind a roughing cycle, which they follow, the program goes on behind them.

#include <leadscrew/gcode/flow.hpp>

namespace leadscrew::gcode {

Flow::Next Flow::call_profile(const Block& cycle, const TextLine& line) {
  text_.keep(line);
  TextLine of_block = line;
  Statement at;
  StatementName first = 0, last = 0;
  Label begin, end;
  at.column = cycle.column_of('P');
  if (!statements_.number(cycle['P'], at.column, first)) return Next::stop;
  if (!find_label(static_cast<std::int64_t>(first), of_block, at, begin)) return Next::stop;
  at.column = cycle.column_of('Q');
  if (!statements_.number(cycle['Q'], at.column, last)) return Next::stop;
  if (!find_label(static_cast<std::int64_t>(last), of_block, at, end)) return Next::stop;
  if (end.place.offset < begin.place.offset) {
    return error(at, "bad-contour", "the block Q of the contour stands before the block P", "P begins it, Q ends it");
  }
  Call call{.kind = CallKind::profile, .name = last, .body = begin.place, .program = program_begin()};
  const bool is_behind = begin.place.offset >= text_.place().offset;
  call.goes_on = is_behind && !cycle.is(Code::G70_profile);
  return begin_call(std::move(call), at);
}

Flow::Next Flow::end_profile() {
  Statement at;
  at.column = 1;
  Call& last = calls_.back();
  if (last.goes_on) last.return_to = text_.place();
  return end_call(std::nullopt, at);
}

Flow::Next Flow::call_pocket(const Block& cycle, const TextLine& line) {
  text_.keep(line);
  TextLine of_block = line;
  Statement at;
  at.column = cycle.column_of('P');
  StatementName number = 0;
  if (!statements_.number(cycle['P'], at.column, number)) return Next::stop;
  Label label;
  int count = 0;
  if (!scan_label(static_cast<std::int64_t>(number), program_begin(), label, count) || !return_to_line(of_block))
    return Next::stop;
  Call call{.kind = CallKind::block_number, .name = number};
  if (count > 0) {
    call.body = label.place;
    call.program = program_begin();
    return begin_call(std::move(call), at);
  }
  const Sub* const sub = find_sub(number, true, of_block);
  if (!sub) return Next::stop;
  call.kind = CallKind::program;
  call.body = call.program = sub->body;
  return begin_call(std::move(call), at);
}

}  // namespace leadscrew::gcode
