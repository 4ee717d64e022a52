#include <algorithm>
#include <cmath>
#include <leadscrew/drive/live_program.hpp>
#include <leadscrew/drive/pause.hpp>
#include <leadscrew/drive/word_maker.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/realtime/schedule.hpp>
#include <utility>

namespace leadscrew::drive {

namespace {

constexpr double least_spare = 0.1;       // s planned behind the words that are made ahead
constexpr double usual_look_ahead = 0.3;  // s, where nothing else is asked for
constexpr double least_look_ahead = 0.02;

}  // namespace

WordMaker::WordMaker(const files::InputFile& program, const Setup& setup, const base::Word& first, Link& link,
                     MayStart may_start)
    : program_(program),
      live_(setup.options.live ? std::make_unique<LiveProgram>(setup, program.name()) : nullptr),
      source_(source_of(setup)),
      lead_(setup.options.lead + slice_duration),
      sink_(link, setup.machine, first.position, setup.most_waiting()) {
  source_.unchanged = [this] { return program_.unchanged(); };
  if (setup.machine.rotary_chain) source_.tell_tool();
  source_.stop_when(files::interrupted);
  source_.planner().slice(longest_chunk);
  source_.planner().start_at(first.path_length, first.line);
  const Options& options = setup.options;
  const std::int64_t slice = setup.words_of_slice();
  const realtime::RunnerOptions runner_options = {
      .period = setup.machine.period,
      .position = first.position,
      .path_length = first.path_length,
      .line = first.line,
      .look_ahead = std::max(options.look_ahead.value_or(usual_look_ahead), options.lead + least_spare) +
                    static_cast<double>(slice) * setup.machine.period.seconds(),
      .least_look_ahead = options.look_ahead ? std::nullopt : std::optional(least_look_ahead),
      .lead = setup.words_in(options.lead),
      .slice = slice,
      .spindle = setup.machine.threads_follow() ? setup.machine.spindle : std::nullopt};
  source_.follow_spindle();
  runner_.emplace(runner_options, planning(std::move(may_start)), sink_.sink());
}

WordMaker::~WordMaker() = default;

pipeline::MotionSource WordMaker::source_of(const Setup& setup) {
  if (live_) {
    return pipeline::MotionSource([this](gcode::Move& move) { return live_->moves().give(move); }, setup.machine,
                                  setup.reading.start);
  }
  return pipeline::MotionSource(counted(program_.source()), setup.machine, setup.tools,
                                setup.speaking(setup.reader_options(program_)), nullptr);
}

std::int64_t WordMaker::blocks() const {
  return live_ ? live_->blocks() : source_.blocks();
}

void WordMaker::conclude() {
  counters_ = runner_->counters();
  latencies_ = runner_->latencies();
  if (counters_.words > 0) notice_ = runner_->notice();
  refused_chunk_ = runner_->failure();
  runner_.reset();
  if (live_) live_->end();
}

std::optional<base::Diagnostic> WordMaker::failure() const {
  if (source_.failure()) return source_.failure();
  if (live_ && live_->failure()) return live_->failure();
  if (refused_chunk_) return refused_chunk_;
  if (auto refused = sink_.problem()) return refused;
  // Read to its end before it was changed: motion is that of the program, but no file tells any more of which.
  if (auto same = program_.unchanged(); !same) return same.error();
  return std::nullopt;
}

gcode::ByteSource WordMaker::counted(gcode::ByteSource source) {
  return [this, source = std::move(source)](std::span<char> bytes) {
    auto got = source(bytes);
    if (got) bytes_read_.fetch_add(static_cast<std::int64_t>(*got), std::memory_order_relaxed);
    return got;
  };
}

realtime::Planning WordMaker::planning(MayStart may_start) {
  realtime::Planning planning{.next = [this] { return next_chunk(); },
                              .refuse = [this] { source_.planner().refuse(); },
                              .override_feed = [this](double factor) { source_.planner().override_feed(factor); },
                              .spindle_turns = [this](double speed) { source_.planner().spindle_turns(speed); },
                              .lets =
                                  [this, may_start = std::move(may_start)](const planner::Chunk& chunk) {
                                    if (!inputs_let(chunk)) return false;
                                    if (may_start && !(stands_before(chunk) && may_start(chunk))) return false;
                                    input_wait_.end();
                                    stood_since_.reset();
                                    return true;
                                  },
                              .slice = [this](double seconds) { source_.planner().slice(seconds); },
                              .come_to_rest = [this] { source_.planner().come_to_rest(); },
                              .is_held = [this] { return source_.planner().is_held(); }};
  if (!live_) return planning;
  planning.drought = [this] { return source_.wants_moves() ? std::optional(live_->moves().drought()) : std::nullopt; };
  planning.end_for_now = [this] { live_->moves().end_for_now(); };
  return planning;
}

bool WordMaker::inputs_let(const planner::Chunk& chunk) {
  return input_wait_.may_start(chunk, !has_motion_ahead(), lead_, realtime::now());
}

/// Longer than a slice?
bool WordMaker::has_motion_ahead() const {
  const realtime::Counters counters = runner_->counters();
  return counters.seconds_ahead > 0 || counters.in_step;
}

bool WordMaker::stands_before(const planner::Chunk& chunk) {
  if (!Pause::line_before(chunk)) return true;
  if (has_motion_ahead()) return false;
  const std::int64_t now = realtime::now();
  if (!stood_since_) stood_since_ = now;
  return static_cast<double>(now - *stood_since_) >= lead_ * 1e9;
}

std::optional<planner::Chunk> WordMaker::next_chunk() {
  std::optional<planner::Chunk> chunk = source_.next();
  // Before the runner knows that this was the last.
  if (source_.failure() || (live_ && live_->has_failed())) has_failed_.store(true, std::memory_order_release);
  return chunk;
}

}  // namespace leadscrew::drive
