#include <algorithm>
#include <leadscrew/nc/nc_program.hpp>
#include <leadscrew/nc/pulse_program.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <utility>

namespace leadscrew::nc {

namespace {

/// The feed where its word changes.
struct Changing {
  RampedFeed* feed;
  std::int64_t commands_left;

  std::int64_t skip() { return feed->skip(commands_left--); }
};

constexpr std::int64_t most_changing = 64;  // commands, before it is seen whether the word is steady by now

}  // namespace

std::int64_t check_pulses(gcode::ByteSource source, const machine::Machine& machine, const machine::ToolTable& tools,
                          const gcode::ReaderOptions& reading, const PulseOptions& options,
                          const gcode::DiagnosticSink& sink, const GoesOn& goes_on, const BlockCheck& more) {
  gcode::Reader reader(std::move(source), machine, tools, reading, sink);
  BlockMaker maker(machine, options, reading.start);
  gcode::Move move;
  while (goes_on() && reader.next(move)) {
    // Of a block that the reader refuses there is no move.
    maker.stand_at(move.start);
    maker.load(move);
    while (goes_on()) {
      auto planned = maker.next();
      if (!planned) break;
      auto problem = !*planned ? std::optional(planned->error()) : more ? more((*planned)->block) : std::nullopt;
      if (problem) reader.reject(move, std::move(*problem));
    }
  }
  return reader.errors() + (reader.source_failure() ? 1 : 0);
}

PulseProgram::PulseProgram(gcode::ByteSource source, const machine::Machine& machine, const machine::ToolTable& tools,
                           const gcode::ReaderOptions& reading, const PulseOptions& options, gcode::DiagnosticSink sink)
    : options_(options),
      reader_(std::move(source), machine, tools, reading, std::move(sink)),
      maker_(machine, options, reading.start),
      ahead_(machine),
      feed_(options.feed_capacity) {}

std::int64_t PulseProgram::errors() const {
  return reader_.errors() + (reader_.source_failure() ? 1 : 0);
}

void PulseProgram::override_feed(int thousandths) {
  override_ = std::clamp(thousandths, 1, greatest_override);
  aim();
}

std::span<const steps::StepEvent> PulseProgram::next(std::span<steps::StepEvent> buffer) {
  StepWriter steps(buffer, tick_);
  while (interpolator_.done()) {
    if (!begin_block()) return steps.written();
    steps.pass(tick_ - steps.tick());
  }
  while (!interpolator_.done() && !steps.is_full()) {
    const std::int64_t steady = feed_.steady(commands_left_);
    Changing changing{&feed_, commands_left_};
    const std::int64_t made = steady > 0 ? interpolator_.run(feed_.at_its_word(), steady, steps)
                                         : interpolator_.run(changing, most_changing, steps);
    commands_left_ -= made;
    commands_ += made;
  }
  tick_ = steps.tick();
  return steps.written();
}

/// Reads on until so much is known that nothing behind can matter, or until the first problem.
void PulseProgram::fill() {
  const std::size_t blocks_wanted = options_.shape == Shape::accelerate ? BlockLookAhead::most_blocks : 1;
  while (reading_ && ahead_.size() < blocks_wanted) {
    auto planned = maker_.next();
    if (!planned) {
      reading_ = errors() == 0 && reader_.next(move_);
      if (reading_) maker_.load(move_);
    } else if (*planned) {
      ahead_.push(**planned);
    } else {
      reader_.reject(move_, std::move(planned->error()));
      reading_ = false;
    }
  }
}

void PulseProgram::aim() {
  const Block& block = planned_.block;
  feed_.aim(std::clamp<std::int64_t>(block.feed_word * override_ / full_override, 1,
                                     std::max<std::int64_t>(block.greatest_word, 1)));
}

bool PulseProgram::begin_block() {
  fill();
  if (ahead_.is_empty()) return false;
  const double speed = this->speed();
  const BlockLookAhead::Next next = ahead_.pop(static_cast<double>(override_) / full_override);
  planned_ = next.planned;
  const Block& block = planned_.block;
  if (block.kind == Block::Kind::dwell) {
    tick_ += block.dwell_clocks;
    return true;
  }
  interpolator_ = BlockInterpolator(block, options_.method, options_.interpolation, maker_.tape());
  commands_left_ = block.commands - block.uncertain;
  aim();
  begin_feed(next, speed);
  return true;
}

void PulseProgram::begin_feed(const BlockLookAhead::Next& next, double speed) {
  if (options_.shape == Shape::constant) {
    feed_.begin_constant();
    return;
  }
  const auto word = [&](double rate) { return std::max<std::int64_t>(1, word_of(rate, options_)); };
  const double rate = std::clamp(speed / numeric::norm(planned_.entry), next.rest_rate, next.entry_rate);
  feed_.begin(word(rate), word(next.exit_rate), acceleration_word(planned_.acceleration, options_));
}

double PulseProgram::speed() const {
  if (planned_.block.commands == 0) return 0;
  const double share = static_cast<double>(feed_.word()) / static_cast<double>(options_.feed_capacity);
  return share * static_cast<double>(options_.clock_pps) * numeric::norm(planned_.exit);
}

}  // namespace leadscrew::nc
