#include <algorithm>
#include <cmath>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/host/motion.hpp>
#include <utility>

namespace leadscrew::host {

Motion::Motion(machine::Machine machine, MotionOptions options)
    : machine_(std::move(machine)), options_(std::move(options)), tolerance_(machine_.tolerance) {
  begin();
}

Motion::Motion(machine::Machine machine, MotionOptions options, std::string text)
    : machine_(std::move(machine)),
      options_(std::move(options)),
      text_(std::move(text)),
      tolerance_(machine_.tolerance),
      finished_(true) {
  begin();
}

base::Result<std::unique_ptr<Motion>> Motion::of_program(machine::Machine machine, std::string text,
                                                         MotionOptions options,
                                                         const gcode::DiagnosticSink& diagnostics) {
  std::optional<base::Diagnostic> first;
  gcode::Reader reader(gcode::text_source(text), machine, options.tools, {options.file, options.start},
                       [&](const base::Diagnostic& diagnostic) {
                         if (diagnostic.severity == base::Severity::error && !first) first = diagnostic;
                         if (diagnostics) diagnostics(diagnostic);
                       });
  gcode::Move move;
  while (reader.next(move)) continue;
  if (first) return base::failure(*first);
  return std::unique_ptr<Motion>(new Motion(std::move(machine), std::move(options), std::move(text)));
}

void Motion::begin() {
  end_ = options_.start;
  if (text_) {
    program_.emplace(gcode::text_source(*text_), machine_, options_.tools,
                     gcode::ReaderOptions{options_.file, options_.start}, nullptr);
  } else {
    program_.emplace([this](gcode::Move& move) { return give(move); }, machine_, options_.start);
  }
  program_->slice(options_.slice);
  if (options_.on_event) program_->on_event(options_.on_event);
}

pipeline::Supply Motion::give(gcode::Move& move) {
  if (moves_.empty()) return finished_ ? pipeline::Supply::end : pipeline::Supply::later;
  move = std::move(moves_.front());
  moves_.pop_front();
  return pipeline::Supply::move;
}

base::Result<void> Motion::smooth(double tolerance) {
  if (!(tolerance >= 0 && std::isfinite(tolerance)))
    return base::failure(base::problem("tolerance", "a tolerance of " + base::text(tolerance, 9) + " mm", "0 or more"));
  tolerance_ = tolerance;
  return {};
}

base::Result<void> Motion::push(gcode::Move move) {
  if (finished_)
    return base::failure(base::problem("motion-ended", "no move is taken any more", "reset it at its end"));
  if (auto sound = put_behind(end_, machine_, move); !sound) return sound;
  move.path_mode = tolerance_ > 0 ? gcode::PathMode::blend : gcode::PathMode::exact_path;
  move.tolerance = move.naive_cam_tolerance = tolerance_;
  end_ = move.end;
  moves_.push_back(std::move(move));
  return {};
}

/// A dwell of no time, for which motion rests.
void Motion::end_for_now() {
  gcode::Move rest = dwell(0);
  rest.start = rest.end = end_;
  if (!finished_) moves_.push_back(std::move(rest));
}

std::size_t Motion::next(std::span<base::Word> words) {
  std::size_t count = 0;
  while (count < words.size() && program_->prepare()) count += program_->cycle(words.subspan(count)).size();
  return count;
}

base::Result<void> Motion::override_feed(double factor) {
  if (!(factor >= 0 && factor <= 2))
    return base::failure(base::problem("override", "a feed override of " + base::text(factor, 9), "0 to 2"));
  program_->override_feed(factor);
  return {};
}

void Motion::abort() {
  finished_ = true;
  moves_.clear();
  program_->abort();
}

base::Result<void> Motion::reset(const base::AxisVector& position) {
  if (progress() != pipeline::Progress::ended)
    return base::failure(base::problem("motion-moves", "motion has not come to its end", "take words until it has"));
  if (auto inside = check_position(position, machine_); !inside) return inside;
  text_.reset();
  moves_.clear();
  finished_ = false;
  options_.start = position;
  begin();
  return {};
}

}  // namespace leadscrew::host
