#include <algorithm>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/planner/limit_ratios.hpp>
#include <utility>

namespace leadscrew::pipeline {

void account(const gcode::Move& move, Summary& summary) {
  if (move.kind == gcode::Move::Kind::dwell) summary.dwell_s += move.dwell_seconds;
  if (move.kind == gcode::Move::Kind::dwell || move.kind == gcode::Move::Kind::event) return;
  ++summary.moves;
  summary.tolerance_mm = std::max(summary.tolerance_mm, move.tolerance);
  const double value = move.feed.value;
  switch (move.feed.mode) {
    case gcode::Feed::Mode::units_per_second:
      summary.feed_programmed_max = std::max(summary.feed_programmed_max, value);
      break;
    case gcode::Feed::Mode::per_second:
      summary.feed_programmed_max = std::max(summary.feed_programmed_max, value * toolpath::feed_length(move));
      break;
    case gcode::Feed::Mode::rapid:
      break;
  }
}

Program::Program(gcode::ByteSource source, base::Borrowed<machine::Machine> machine,
                 base::Borrowed<machine::ToolTable> tools, const gcode::ReaderOptions& options,
                 gcode::DiagnosticSink diagnostics)
    : machine_(machine),
      constraints_(machine_),
      source_(std::move(source), machine, tools, options, std::move(diagnostics)),
      bound_(machine_),
      interpolator_(machine_.period, options.start) {
  watch_path();
}

Program::Program(MoveInput moves, base::Borrowed<machine::Machine> machine, const geometry::Point& start)
    : machine_(machine),
      constraints_(machine_),
      source_(std::move(moves), machine, start),
      bound_(machine_),
      interpolator_(machine_.period, start) {
  watch_path();
}

void Program::watch_path() {
  if (machine_.threads_follow()) {
    interpolator_.follow(*machine_.spindle);
    source_.follow_spindle();
  }
  source_.on_move = [this](const gcode::Move& move) { account(move); };
  source_.on_element = [this](const toolpath::Element& element) { bound_.push(element); };
}

bool Program::prepare() {
  progress_ = find_word();
  return progress_ == Progress::moving;
}

Progress Program::find_word() {
  if (ended_) return Progress::ended;
  while (interpolator_.wants_chunk()) {
    if (plan_next()) continue;
    if (source_.wants_input()) {
      tell_events(interpolator_.events_of_part(), interpolator_.tick());
      return Progress::wants_input;
    }
    if (source_.waits_for_probe() && (found_ || !source_.planner().is_held())) {
      if (interpolator_.has_stop_tail_left()) {
        stop();
      } else {
        conclude_probing();
      }
      continue;
    }
    if (!source_.is_cut_short()) {
      if (source_.wants_moves()) return Progress::wants_moves;
      if (source_.planner().is_held()) return Progress::held;
    }
    if (interpolator_.has_stop_tail_left()) {  // the motion has failed, or was aborted
      stop();
      continue;
    }
    // The plan has ended: the word at its end, at rest, is the last.
    ended_ = true;
    break;
  }
  return Progress::moving;
}

base::Word Program::cycle() {
  const base::Word word = interpolator_.next();
  tell_events(interpolator_.events_passed(), word.tick);
  account(word);
  return word;
}

std::span<const base::Word> Program::cycle(std::span<base::Word> words) {
  std::size_t count = interpolator_.next(words);
  if (count == 0) words[count++] = interpolator_.next();  // at rest, at the end
  // Several at once only where no event is left in the part.
  tell_events(interpolator_.events_passed(), words[count - 1].tick);
  for (const base::Word& word : words.first(count)) account(word);
  return words.first(count);
}

/// As many of the chunk's.
void Program::tell_events(std::size_t count, base::Tick tick) {
  for (; told_ < count; ++told_) {
    const planner::PlacedEvent& event = chunk_.event(told_);
    if (events_ && event.kind != base::Event::Kind::feed_per_revolution) events_(planner::passed_at(tick, event));
  }
}

/// Goes on through the stop tail of the last chunk, which becomes part of the motion.
void Program::stop() {
  planner::Chunk tail = chunk_;
  tail.segments = tail.stop_tail;
  planner::raise_limit_ratios(tail, constraints_, summary_.plan);
  summary_.length_mm += chunk_.tail_length;
  interpolator_.run_stop_tail();
}

void Program::abort() {
  source_.abort();
  interpolator_.leave_step();
}

const gcode::Move* Program::probing() const {
  const std::optional<gcode::Move>& move = source_.probing();
  return move && move->line == last_line_ ? &*move : nullptr;
}

void Program::probe_found(const base::AxisVector& position) {
  if (probing() == nullptr || found_) return;
  found_ = gcode::Probed{true, base::count(line_begin_) == summary_.words, position, position};
  source_.end_probing();
}

/// The probing move has ended, at rest.
void Program::conclude_probing() {
  const geometry::Point& rest = source_.rest();
  gcode::Probed result = found_.value_or(gcode::Probed{false, false, rest, rest});
  result.rest = rest;
  source_.probed(result);
  found_.reset();
}

bool Program::plan_next() {
  if (machine_.threads_follow()) source_.planner().spindle_turns(interpolator_.spindle_speed());
  std::optional<planner::Chunk> chunk = source_.next();
  summary_.blocks = source_.blocks();
  if (source_.has_read_all() && !bound_is_known_) {
    bound_is_known_ = true;
    bound_.finish();
    summary_.bound_s = bound_.seconds();
  }
  if (!chunk) return false;
  tell_events(interpolator_.events_of_part(), interpolator_.tick());
  told_ = 0;
  interpolator_.leave_chunk();
  chunk_ = std::move(*chunk);
  planner::raise_limit_ratios(chunk_, constraints_, summary_.plan);
  summary_.length_mm += chunk_.length;
  interpolator_.load(chunk_);
  return true;
}

void Program::account(const gcode::Move& move) {
  if (moves_) moves_(move);
  pipeline::account(move, summary_);
}

void Program::account(const base::Word& word) {
  if (word.line != last_line_) line_begin_ = word.tick;
  last_line_ = word.line;
  summary_.words = base::count(word.tick);
  summary_.time_s = base::seconds(word.tick, machine_.period);
  summary_.threads = interpolator_.threads();
  if (interpolator_.has_left_step()) summary_.length_mm = word.path_length;  // not the line to its end
}

}  // namespace leadscrew::pipeline
