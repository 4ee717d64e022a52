#include <algorithm>
#include <cmath>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/host/motion.hpp>
#include <utility>

namespace leadscrew::host {

namespace {

constexpr std::size_t bytes_between_questions = 4096;
constexpr std::int64_t moves_between_questions = 4096;  // of one block that repeats itself

base::Diagnostic interruption() {
  return base::problem("interrupted", "interrupted", {});
}

/// The text in small pieces, `share` of it so far; before each it is asked whether to go on.
gcode::ByteSource asking_source(std::string_view text, std::function<bool(double)> goes_on,
                                std::shared_ptr<double> share) {
  if (!goes_on) return gcode::text_source(text);
  return [source = gcode::text_source(text), goes_on = std::move(goes_on), share = std::move(share),
          whole = static_cast<double>(text.size()),
          given = std::size_t{0}](std::span<char> buffer) mutable -> base::Result<std::size_t> {
    *share = whole > 0 ? static_cast<double>(given) / whole : 1;
    if (!goes_on(*share)) return base::failure(interruption());
    const auto count = source(buffer.first(std::min(buffer.size(), bytes_between_questions)));
    if (count) given += *count;
    return count;
  };
}

}  // namespace

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
  const auto share = std::make_shared<double>(0);
  gcode::Reader reader(asking_source(text, options.goes_on, share), machine, options.tools,
                       {options.file, options.start}, [&](const base::Diagnostic& diagnostic) {
                         if (diagnostic.severity == base::Severity::error && !first) first = diagnostic;
                         if (diagnostics) diagnostics(diagnostic);
                       });
  gcode::Move move;
  for (std::int64_t count = 1; reader.next(move); ++count) {
    if (count % moves_between_questions == 0 && options.goes_on && !options.goes_on(*share))
      return base::failure(interruption());
  }
  if (reader.source_failure()) return base::failure(*reader.source_failure());
  if (first) return base::failure(*first);
  return std::unique_ptr<Motion>(new Motion(std::move(machine), std::move(options), std::move(text)));
}

/// Makes what is made of a program or of moves: of this motion's program, or else of `moves`.
template <class Joined>
void Motion::join(std::optional<Joined>& joined, pipeline::MoveInput moves) const {
  const auto share = std::make_shared<double>(0);
  if (text_) {
    joined.emplace(asking_source(*text_, options_.goes_on, share), machine_, options_.tools,
                   gcode::ReaderOptions{options_.file, options_.start}, nullptr);
  } else {
    joined.emplace(std::move(moves), machine_, options_.start);
  }
  if (options_.goes_on) joined->stop_when([this, share] { return !options_.goes_on(*share); });
}

void Motion::begin() {
  end_ = options_.start;
  gave_ = false;
  join(program_, [this](gcode::Move& move) { return give(move); });
  program_->slice(options_.slice);
  if (options_.on_event) program_->on_event(options_.on_event);
}

base::Result<Trajectory> Motion::plan() const {
  if (gave_)
    return base::failure(base::problem("motion-moves", "motion has taken moves already", "plan before the first word"));
  std::optional<pipeline::MotionSource> source;
  auto move = moves_.begin();
  join(source, [&](gcode::Move& next) {
    if (move == moves_.end()) return pipeline::Supply::end;
    next = *move++;
    return pipeline::Supply::move;
  });
  Trajectory trajectory(machine_.period, options_.start);
  while (std::optional<planner::Chunk> chunk = source->next()) trajectory.append(std::move(*chunk));
  if (source->failure()) return base::failure(*source->failure());
  return trajectory;
}

pipeline::Supply Motion::give(gcode::Move& move) {
  if (moves_.empty()) return finished_ ? pipeline::Supply::end : pipeline::Supply::later;
  move = std::move(moves_.front());
  moves_.pop_front();
  gave_ = true;
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
