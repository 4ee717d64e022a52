#include <algorithm>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/pipeline/motion_source.hpp>
#include <leadscrew/toolpath/travel.hpp>
#include <string>
#include <utility>

namespace leadscrew::pipeline {

MotionSource::MotionSource(MoveInput moves, base::Borrowed<machine::Machine> machine, const geometry::Point& start)
    : machine_(machine), start_(start), moves_(std::move(moves)), builder_(*machine), planner_(*machine, start) {
  if (machine->laser && machine->laser->follow_feed) builder_.tell_feed();
}

MotionSource::MotionSource(gcode::ByteSource source, base::Borrowed<machine::Machine> machine,
                           base::Borrowed<machine::ToolTable> tools, const gcode::ReaderOptions& options,
                           gcode::DiagnosticSink diagnostics)
    : MotionSource([this](gcode::Move& move) { return read(move); }, machine, options.start) {
  asks_inputs_ = options.asks_inputs;
  probes_ = options.probing == gcode::ProbingMoves::real;
  gcode::ReaderOptions reading = options;
  if (reading.opener) {
    reading.opener = [this, opener = options.opener](const std::string& name, std::int64_t offset) {
      auto opened = opener(name, offset);
      if (opened) opened->source = watched(std::move(opened->source));
      return opened;
    };
  }
  reader_.emplace(watched(std::move(source)), *machine, *tools, std::move(reading), watched(std::move(diagnostics)));
}

Supply MotionSource::read(gcode::Move& move) {
  const bool has_move = reader_->next(move);
  if (!failure_) failure_ = reader_->source_failure();
  return has_move ? Supply::move : Supply::end;
}

gcode::ByteSource MotionSource::watched(gcode::ByteSource source) {
  return [this, source = std::move(source)](std::span<char> buffer) -> base::Result<std::size_t> {
    auto count = source(buffer);
    if (!count || !unchanged) return count;
    // After the bytes are here, so that none of a file that is being written passes.
    if (auto same = unchanged(); !same) return base::failure(same.error());
    return count;
  };
}

gcode::DiagnosticSink MotionSource::watched(gcode::DiagnosticSink diagnostics) {
  return [this, diagnostics = std::move(diagnostics)](const base::Diagnostic& diagnostic) {
    if (diagnostic.severity == base::Severity::error && !failure_) failure_ = diagnostic;
    if (diagnostics) diagnostics(diagnostic);
  };
}

std::optional<planner::Chunk> MotionSource::next() {
  if (is_cut_short()) return std::nullopt;
  if (unchanged) {
    if (auto same = unchanged(); !same) failure_ = same.error();
  }
  std::optional<planner::Chunk> chunk;
  wants_moves_ = false;
  if (probing_ends_) return chunk;
  while (!failure_ && !(chunk = pop()) && reading_ && !wants_moves_ && !input_ && !probing_ && !planner_.stands_held())
    reading_ = read_move();
  return chunk;
}

void MotionSource::probed(const gcode::Probed& result) {
  probing_.reset();
  if (std::exchange(probing_ends_, false)) planner_.forget_rest();
  reader_->probed(result);
}

std::optional<planner::Chunk> MotionSource::pop() {
  std::optional<planner::Chunk> chunk = planner_.pop();
  if (planner_.is_stopped() && !failure_) failure_ = base::problem("interrupted", "interrupted", {});
  if (planner_.has_failed() && !failure_)
    failure_ = base::problem("planning-failed", "no motion within the machine's limits was found along the path",
                             "this is a defect of leadscrew: please report it, with the program and the machine file");
  return chunk;
}

std::optional<base::Diagnostic> MotionSource::warning() const {
  const std::int64_t count = planner_.simplified_sections();
  if (count == 0) return std::nullopt;
  return base::Diagnostic{
      base::Severity::warning,
      "planning-simplified",
      "the fastest motion would take too long to plan: " + std::to_string(count) + (count == 1 ? " part" : " parts") +
          " of the path are travelled by lower limits than the machine's",
      "limits of acceleration and jerk that are far beyond what the speeds need are the usual cause",
      {},
      {}};
}

/// Reads on by one move, if one is known, and gives the planner what path it settles. False at the end of all moves, or
/// on a failure.
bool MotionSource::read_move() {
  gcode::Move move;
  const Supply supply = moves_(move);
  // A move behind an error may begin where the error would have moved to, not where motion is.
  if (failure_) return false;
  wants_moves_ = supply == Supply::later;
  if (wants_moves_) return true;
  if (supply == Supply::move) {
    if (move.path_mode == gcode::PathMode::blend) tolerance_ = std::max(tolerance_, move.tolerance);
    if (on_move) on_move(move);
    if (move.is_probing() && probes_) begin_probing(move);
    builder_.push(move);
    if (asks_inputs_ && move.kind == gcode::Move::Kind::event && base::is_input(move.event.kind)) input_ = move.event;
  } else {
    builder_.finish();
  }
  if (!settle()) return false;
  if (supply == Supply::end) planner_.finish();
  return supply == Supply::move;
}

/// A word at least stands at rest before, so that the probe can be looked at.
void MotionSource::begin_probing(const gcode::Move& move) {
  probing_ = move;
  gcode::Move rest;
  rest.kind = gcode::Move::Kind::dwell;
  rest.start = rest.end = move.start;
  rest.line = move.line;
  rest.dwell_seconds = 2 * machine_.period.seconds();
  builder_.push(rest);
}

/// Gives the planner what path is settled; false if that fails.
bool MotionSource::settle() {
  while (std::optional<toolpath::Element> element = builder_.pop()) {
    if (!push(std::move(*element))) return false;
  }
  return true;
}

/// To the planner. False where it leaves the travel of an axis: that fails.
bool MotionSource::push(toolpath::Element element) {
  constexpr double rounding = 2e-6;  // mm or degrees: the reader's of curves, and the path's
  if (auto* piece = std::get_if<toolpath::Piece>(&element)) {
    if (const auto excess = toolpath::check_travel(*piece, machine_, start_, tolerance_ + rounding)) {
      failure_ =
          base::problem("travel",
                        std::string("the path would lead axis ") + base::letter(excess->axis) + " to " +
                            base::text(excess->position, 9) + ", outside its travel",
                        "this is a defect of leadscrew: please report it, with the program and the machine file");
      failure_->place.line = base::number(piece->line);
      return false;
    }
  }
  planner_.push(element);
  if (on_element) on_element(element);
  return true;
}

}  // namespace leadscrew::pipeline
