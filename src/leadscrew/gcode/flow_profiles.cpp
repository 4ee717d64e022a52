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
  if (!cycle.is(Code::G70_profile) && !pass_to_contour(begin.place, of_block, call.goes_on)) return Next::stop;
  return begin_call(std::move(call), at);
}

namespace {

/// Has the line M2, M30 or M99?
bool ends_program(const char* p) {
  for (int depth = 0; *p != '\n' && *p != ';'; ++p) {
    depth += (*p == '(') - (*p == ')');
    if (depth > 0 || (*p != 'M' && *p != 'm')) continue;
    int number = 0;
    while (p[1] == ' ' || (p[1] >= '0' && p[1] <= '9')) {
      if (*++p != ' ') number = std::min(10 * number + (*p - '0'), 1000);
    }
    if (number == 2 || number == 30 || number == 99) return true;
  }
  return false;
}

}  // namespace

/// Does the program go on behind a contour that begins there, for it stands behind the cycle and before the program's end?
/// Blocks between are then passed over, of which is warned. The next line is still that behind `line`.
bool Flow::pass_to_contour(const TextPlace& begin, TextLine& line, bool& goes_on) {
  goes_on = begin.offset >= text_.place().offset;
  if (!goes_on) return true;
  base::Line first{}, last{};
  for (TextLine between = line; text_.next(between) && place_of(between).offset < begin.offset;) {
    if (counts_) --fuel_;
    const char* p = between.text;
    skip_remarks(p);
    if (*p == '\n' || *p == '%' || *p == ';') continue;
    goes_on = goes_on && !ends_program(p);
    if (base::number(first) == 0) first = between.id;
    last = between.id;
  }
  if (text_.failure() || !return_to_line(line)) return false;
  if (!goes_on || base::number(first) == 0) return true;
  const std::string from = std::to_string(base::number(first)), to = std::to_string(base::number(last));
  reporter_.warning("passed-over", line.text - line.begin + 1,
                    (from == to ? "line " + from + " stands" : "lines " + from + " to " + to + " stand") +
                        " between the cycle and its contour, and the program goes on behind the contour",
                    "put them before the cycle or behind the contour; or the contour behind M30");
  return true;
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
