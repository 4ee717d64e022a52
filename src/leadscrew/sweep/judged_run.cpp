#include <algorithm>
#include <array>
#include <leadscrew/base/hash.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/sweep/judged_run.hpp>

namespace leadscrew::sweep {

namespace {

/// As the referee has it: a limit is not kept when it is passed by more than 0.1 %.
constexpr double largest_ratio = 1.001;
constexpr double largest_end_error = 1e-6;  // mm

/// The referee's own reading. What an override above 1 makes of the feed is no fault; below 1 the feed word still holds.
referee::MoveSource moves_of(gcode::Reader& reader, const RunSetup& setup) {
  double factor = std::max(1.0, setup.override_factor);
  for (const campaign::FeedChange& change : setup.changes) factor = std::max(factor, change.factor);
  return [&reader, factor](gcode::Move& move) {
    if (!reader.next(move)) return false;
    move.feed.value *= factor;
    return true;
  };
}

/// What is asked of the feed meanwhile.
class Changes {
 public:
  Changes(const std::vector<campaign::FeedChange>& changes, pipeline::Program& program)
      : changes_(changes), program_(program) {
    if (!changes.empty()) program.slice(slice);
  }

  /// Before the word of this number. So many may be made before the next change.
  std::size_t ask(std::int64_t word) {
    while (next_ < changes_.size() && changes_[next_].tick <= word) program_.override_feed(changes_[next_++].factor);
    return next_ == changes_.size() ? most_words : static_cast<std::size_t>(changes_[next_].tick - word);
  }
  /// Held, at rest: the next change comes without a word between. False if there is none.
  bool go_on() {
    if (program_.progress() != pipeline::Progress::held || next_ == changes_.size()) return false;
    program_.override_feed(changes_[next_++].factor);
    return true;
  }

  static constexpr std::size_t most_words = 64;

 private:
  static constexpr double slice = 0.02;  // s

  const std::vector<campaign::FeedChange>& changes_;
  pipeline::Program& program_;
  std::size_t next_ = 0;
};

void add_positions(base::Hash& hash, std::span<const base::Word> words) {
  for (const base::Word& word : words)
    hash.add({reinterpret_cast<const char*>(word.position.data()), sizeof word.position});
}

}  // namespace

std::array<double, 3> JudgedRun::worst_ratios() const {
  std::array<double, 3> worst{};
  for (const referee::AxisVerdict& axis : verdict.axes) {
    worst[0] = std::max(worst[0], axis.velocity_ratio);
    worst[1] = std::max(worst[1], axis.acceleration_ratio);
    worst[2] = std::max(worst[2], axis.jerk_ratio);
  }
  return worst;
}

bool JudgedRun::kept() const {
  return !verdict.objects() && summary.plan.greatest() <= largest_ratio && verdict.end_error_mm <= largest_end_error;
}

base::Result<JudgedRun> run_judged(const RunSetup& setup) {
  const auto cancelled = [&] { return files::interrupted() || (setup.is_cancelled && setup.is_cancelled()); };
  pipeline::Program program(setup.source(), setup.machine, setup.tools, setup.options, nullptr);
  program.stop_when(cancelled);
  if (setup.unchanged) program.watch(setup.unchanged);
  if (setup.override_factor != 1) program.override_feed(setup.override_factor);
  JudgedRun run;
  pipeline::LostTime lost(setup.machine, {});
  program.on_move([&](const gcode::Move& move) { lost.observe(move); });
  gcode::Reader reader(setup.source(), setup.machine, setup.tools, setup.options, nullptr);
  referee::Referee referee(moves_of(reader, setup), setup.machine, setup.machine.period, cancelled);
  base::Hash positions;
  std::array<base::Word, Changes::most_words> words;
  Changes changes(setup.changes, program);
  std::int64_t count = 0;
  while (true) {
    const std::size_t most = std::min(words.size(), changes.ask(count));
    if (!program.prepare()) {
      if (changes.go_on()) continue;
      break;
    }
    const auto made = program.cycle(std::span(words).first(most));
    count += static_cast<std::int64_t>(made.size());
    add_positions(positions, made);
    for (const base::Word& word : made) {
      referee.observe(word.position, word.feed);
      lost.observe(word);
    }
    if (cancelled()) return base::failure(files::interruption());
  }
  if (program.failure()) return base::failure(*program.failure());
  lost.finish();
  run.verdict = referee.conclude();
  if (cancelled()) return base::failure(files::interruption());
  if (reader.source_failure()) return base::failure(*reader.source_failure());
  run.summary = program.summary();
  run.lost = lost.by_cause();
  run.words_hash = positions.value();
  return run;
}

}  // namespace leadscrew::sweep
