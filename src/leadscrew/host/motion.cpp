#include <algorithm>
#include <cmath>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/host/motion.hpp>
#include <leadscrew/host/program_reading.hpp>
#include <leadscrew/planner/limit_ratios.hpp>
#include <limits>
#include <utility>

namespace leadscrew::host {

namespace {

constexpr std::int64_t moves_between_questions = 4096;  // of one block that repeats itself

base::Result<void> check_override(double factor) {
  if (factor >= 0 && factor <= 2) return {};
  return base::failure(base::problem("override", "a feed override of " + base::text(factor, 9), "0 to 2"));
}

base::Result<void> check(std::span<const FeedChange> changes) {
  double before = 0;
  for (const FeedChange& change : changes) {
    if (auto sound = check_override(change.factor); !sound) return sound;
    if (!(change.time >= before && std::isfinite(change.time))) {
      return base::failure(base::problem("override", "feed changes at " + base::text(change.time, 9) + " s",
                                         "times in their order, from 0"));
    }
    before = change.time;
  }
  return {};
}

}  // namespace

Motion::Motion(machine::Machine machine, MotionOptions options)
    : machine_(std::move(machine)), options_(std::move(options)), moves_(machine_, options_.start) {
  begin();
}

Motion::Motion(machine::Machine machine, MotionOptions options, std::shared_ptr<ProgramTexts> texts)
    : machine_(std::move(machine)),
      options_(std::move(options)),
      texts_(std::move(texts)),
      moves_(machine_, options_.start) {
  moves_.finish();
  begin();
}

base::Result<std::unique_ptr<Motion>> Motion::of_program(machine::Machine machine, std::string text,
                                                         MotionOptions options,
                                                         const gcode::DiagnosticSink& diagnostics) {
  std::optional<base::Diagnostic> first;
  const auto share = std::make_shared<double>(0);
  auto texts = std::make_shared<ProgramTexts>(std::move(text), options.subprogram);
  gcode::Reader reader(asking_source(texts->program(), options.goes_on, share), machine, options.tools,
                       reading_of(machine, options, texts), [&](const base::Diagnostic& diagnostic) {
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
  return std::unique_ptr<Motion>(new Motion(std::move(machine), std::move(options), std::move(texts)));
}

/// Makes what is made of a program or of moves: of this motion's program, or else of `moves`.
template <class Joined>
void Motion::join(std::optional<Joined>& joined, pipeline::MoveInput moves) const {
  const auto share = std::make_shared<double>(0);
  if (texts_) {
    joined.emplace(asking_source(texts_->program(), options_.goes_on, share), machine_, options_.tools,
                   reading_of(machine_, options_, texts_), nullptr);
  } else {
    joined.emplace(std::move(moves), machine_, options_.start);
  }
  if (options_.goes_on) joined->stop_when([this, share] { return !options_.goes_on(*share); });
}

void Motion::begin() {
  join(program_, [this](gcode::Move& move) { return moves_.give(move); });
  program_->slice(options_.slice);
  program_->step_by(options_.step_rule);
  feed_override_ = 1;
  if (options_.on_event) program_->on_event(options_.on_event);
}

base::Result<Trajectory> Motion::plan(PlanNotes* notes, FeedChanges changes) const {
  if (moves_.has_given())
    return base::failure(base::problem("motion-moves", "motion has taken moves already", "plan before the first word"));
  std::optional<pipeline::MotionSource> source;
  auto move = moves_.waiting().begin();
  join(source, [&](gcode::Move& next) {
    if (move == moves_.waiting().end()) return pipeline::Supply::end;
    next = *move++;
    return pipeline::Supply::move;
  });
  if (feed_override_ == 0) return base::failure(base::problem("override", "motion is held", "a feed override above 0"));
  if (auto sound = check(changes); !sound) return base::failure(sound.error());
  source->planner().override_feed(feed_override_);
  return notes == nullptr ? plan_from(*source, changes) : plan_noted(*source, changes, *notes);
}

base::Result<Trajectory> Motion::plan_from(pipeline::MotionSource& source, FeedChanges changes,
                                           const ChunkSink& sink) const {
  Trajectory trajectory(machine_.period, options_.start);
  auto change = changes.begin();
  for (;;) {
    const double now = trajectory.duration();
    for (; change != changes.end() && change->time <= now; ++change) source.planner().override_feed(change->factor);
    // What is committed to ends where feed changes next.
    const double left = change == changes.end() ? std::numeric_limits<double>::infinity() : change->time - now;
    if (!changes.empty()) source.planner().slice(std::max(left, machine_.period.seconds()));
    if (std::optional<planner::Chunk> chunk = source.next()) {
      if (sink) sink(*chunk);
      trajectory.append(std::move(*chunk));
    } else if (source.wants_input()) {
      source.input_is({});
    } else if (source.waits_for_probe()) {
      source.probed({true, false, source.rest(), source.rest()});
    } else if (source.planner().is_held() && change != changes.end() && !source.failure()) {
      trajectory.stand(left);
    } else {
      break;
    }
  }
  if (source.failure()) return base::failure(*source.failure());
  return trajectory;
}

base::Result<Trajectory> Motion::plan_noted(pipeline::MotionSource& source, FeedChanges changes,
                                            PlanNotes& notes) const {
  const constraints::Constraints constraints(machine_);
  planner::TimeBound bound(machine_);
  notes.summary = {};
  source.tell_tool();
  source.on_element = [&](const toolpath::Element& element) { bound.push(element); };
  source.on_move = [&](const gcode::Move& move) {
    pipeline::account(move, notes.summary);
    if (notes.on_move) notes.on_move(move, source.machined());
  };
  auto trajectory = plan_from(source, changes, [&](const planner::Chunk& chunk) {
    planner::raise_limit_ratios(chunk, constraints, notes.summary.plan);
    notes.summary.length_mm += chunk.length;
  });
  if (!trajectory) return trajectory;
  bound.finish();
  notes.summary.bound_s = bound.seconds();
  notes.summary.blocks = source.blocks();
  notes.summary.words = base::count(trajectory->last_tick());
  notes.summary.time_s = base::seconds(trajectory->last_tick(), machine_.period);
  return trajectory;
}

std::size_t Motion::next(std::span<base::Word> words) {
  std::size_t count = 0;
  while (count < words.size() && program_->prepare()) count += program_->cycle(words.subspan(count)).size();
  if (options_.has_probe && count > 0) last_position_ = words[count - 1].position;
  return count;
}

base::Result<void> Motion::override_feed(double factor) {
  if (auto sound = check_override(factor); !sound) return sound;
  program_->override_feed(factor);
  feed_override_ = factor;
  return {};
}

base::Result<void> Motion::adapt_feed(double factor) {
  if (!(factor >= 0 && factor <= 1))
    return base::failure(base::problem("override", "an adaptive feed of " + base::text(factor, 9), "0 to 1"));
  program_->adapt_feed(factor);
  return {};
}

std::optional<base::Event> Motion::input() const {
  return progress() == pipeline::Progress::wants_input ? program_->input() : std::nullopt;
}

base::Result<void> Motion::input_is(double value) {
  if (!input()) {
    return base::failure(base::problem("input-idle", "an input is told that no program asks for",
                                       "wait until progress() says that it wants one"));
  }
  if (!std::isfinite(value))
    return base::failure(base::problem("move-finite", "the value of an input is not finite", "a number"));
  program_->input_is(value);
  return {};
}

gcode::ProbeSearch Motion::probing() const {
  const gcode::Move* const move = program_->probing();
  return move == nullptr ? gcode::ProbeSearch::nothing : move->probes;
}

base::Result<void> Motion::probe_found(const std::optional<base::AxisVector>& position) {
  if (probing() == gcode::ProbeSearch::nothing) {
    return base::failure(base::problem("probe-idle", "a probe has found something while nothing is being probed",
                                       "ask what the last word is probing before"));
  }
  if (position && !std::ranges::all_of(*position, [](double value) { return std::isfinite(value); }))
    return base::failure(base::problem("move-finite", "a coordinate of the place is not finite", "mm or degrees"));
  program_->probe_found(position.value_or(last_position_));
  return {};
}

void Motion::abort() {
  moves_.abandon();
  program_->abort();
}

base::Result<void> Motion::reset(const base::AxisVector& position) {
  if (progress() != pipeline::Progress::ended)
    return base::failure(base::problem("motion-moves", "motion has not come to its end", "take words until it has"));
  if (auto inside = check_position(position, machine_); !inside) return inside;
  texts_.reset();
  moves_.restart(position);
  options_.start = position;
  begin();
  return {};
}

}  // namespace leadscrew::host
