#include "moving.hpp"

#include <algorithm>
#include <leadscrew/host/program_reading.hpp>
#include <leadscrew/realtime/stop_watch.hpp>
#include <leadscrew/report/traced_words.hpp>

namespace leadscrew::python {

namespace {

constexpr std::size_t words_together = 1024;
constexpr std::int64_t words_between_questions = 1024;

BlockRow row_of(const pipeline::BlockTime& time) {
  BlockRow row{time, {}};
  if (time.lost() <= 0) return row;
  const std::string cause = pipeline::name(time.cause);
  std::copy_n(cause.begin(), std::min(cause.size(), row.cause.size()), row.cause.begin());
  return row;
}

/// The next words, at the end of those that there are.
std::span<const base::Word> next_words(pipeline::Program& program, Words& words, realtime::StopWatch<>& timing) {
  const std::size_t before = words.size();
  const std::size_t most = std::min(timing.words_until_sample(), words_together);
  words.resize(before + std::max<std::size_t>(most, 1));
  if (most == 0) {
    words[before] = timing.cycle([&] { return program.cycle(); });
    return std::span(words).subspan(before);
  }
  const auto made = timing.many([&] { return program.cycle(std::span(words).subspan(before)); });
  words.resize(before + made.size());
  return made;
}

}  // namespace

base::Result<Moved> run(const Work& work, const Reading& reading, Watch& watch) {
  Moved moved;
  moved.diagnostics = reading.diagnostics;
  const auto program = work.program(watch);
  program->on_event([&](const base::PassedEvent& event) { moved.events.push_back(event); });
  if (work.machine().rotary_chain) program->tell_tool();
  pipeline::LostTime lost(work.machine(),
                          [&](const pipeline::BlockTime& time) { moved.blocks.push_back(row_of(time)); });
  program->on_move([&](const gcode::Move& move) { lost.observe(move); });
  const auto ended = [&] { return !watch.goes_on(); };
  referee::Referee referee(work.moves(), work.machine(), work.machine().period, ended);
  realtime::StopWatch<> timing;
  std::int64_t count = 0;
  while (timing.prepare(program->will_plan(), [&] { return program->prepare(); })) {
    for (const base::Word& word : next_words(*program, moved.words, timing)) {
      referee.observe(word.position, word.feed);
      lost.observe(word);
      if (++count % words_between_questions == 0 && ended()) return base::failure(host::interruption());
    }
  }
  if (program->failure()) return base::failure(*program->failure());
  if (const auto warning = program->warning()) moved.diagnostics.push_back(*warning);
  lost.finish();
  referee::Verdict verdict = referee.conclude();
  if (auto same = work.unchanged(); !same) return base::failure(same.error());
  moved.figures = {program->summary(),
                   std::move(verdict),
                   {reading.seconds, timing.preparing(), timing.cycling(), timing.samples()},
                   lost.by_cause(),
                   results::extents_of(work.machine(), lost.least_position(), lost.greatest_position())};
  return moved;
}

base::Result<results::VerifyFigures> judge(const Work& work, const double* positions, std::size_t count, Watch& watch) {
  const machine::Machine& machine = work.machine();
  results::VerifyFigures figures{"<array>", machine.period, {}};
  double share = 0;
  const auto ended = [&] { return !watch.goes_on(share); };
  referee::Referee referee(work.moves(), machine, machine.period, ended);
  report::TracedWords words(machine.period);
  for (std::size_t i = 0; i < count; ++i, positions += base::axis_count) {
    base::AxisVector position;
    std::copy_n(positions, position.size(), position.begin());
    referee.observe(position);
    words.next(position, {});
    share = static_cast<double>(i) / static_cast<double>(count);
    if (i % words_between_questions == 0 && ended()) return base::failure(host::interruption());
  }
  figures.verdict = referee.conclude();
  figures.length_mm = words.length();
  return figures;
}

namespace {

/// Words until the end of the motion, and then the last one until the slides stand.
class Following {
 public:
  Following(drive::Slides& slides, Watch& watch, Simulated& simulated)
      : slides_(slides), watch_(watch), simulated_(simulated) {}

  base::Result<void> follow(pipeline::Program& program) {
    base::Word word;
    while (program.prepare()) {
      word = program.cycle();
      if (auto done = follow(word); !done) return done;
    }
    if (program.failure()) return base::failure(*program.failure());
    word.speed = word.feed = 0;
    word.state = base::MotionState::rest;
    slides_.end_words();
    while (!slides_.has_ended()) {
      word.tick = base::next(word.tick);
      if (auto done = follow(word); !done) return done;
    }
    slides_.finish_contour();
    return {};
  }

 private:
  base::Result<void> follow(const base::Word& word) {
    const auto followed = slides_.follow(word);
    if (!followed) return base::failure(followed.error());
    if (*followed) simulated_.rows.push_back(**followed);
    slides_.take_contour();
    const bool asks = base::count(word.tick) % words_between_questions == 0;
    if (asks && !watch_.goes_on()) return base::failure(host::interruption());
    return {};
  }

  drive::Slides& slides_;
  Watch& watch_;
  Simulated& simulated_;
};

}  // namespace

base::Result<Simulated> simulate(const Work& work, const Reading& reading, drive::LoopKind kind, Watch& watch) {
  Simulated simulated;
  simulated.diagnostics = reading.diagnostics;
  const auto program = work.program(watch);
  if (work.machine().rotary_chain) program->tell_tool();
  auto slides = drive::Slides::create(work.machine(), kind, work.moves());
  if (!slides) return base::failure(slides.error());
  program->on_event([&](const base::PassedEvent& event) { slides->observe(event); });
  if (auto done = Following(*slides, watch, simulated).follow(*program); !done) return base::failure(done.error());
  if (const auto warning = program->warning()) simulated.diagnostics.push_back(*warning);
  simulated.figures = results::SimulateFigures{slides->conclude()};
  simulated.figures.summary = program->summary();
  simulated.figures.tolerance = std::max(simulated.figures.summary.tolerance_mm, work.machine().tolerance);
  return simulated;
}

base::Result<pipeline::Trajectory> plan(const Work& work, Watch& watch) {
  const auto source = work.motion(watch);
  pipeline::Trajectory trajectory(work.machine().period, work.start());
  while (watch.goes_on()) {
    if (auto chunk = source->next()) {
      trajectory.append(std::move(*chunk));
    } else if (source->wants_input()) {
      source->input_is({});
    } else {
      break;
    }
  }
  if (source->failure()) return base::failure(*source->failure());
  return trajectory;
}

}  // namespace leadscrew::python
