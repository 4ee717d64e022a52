#pragma once
// A program run as a controller runs it: chunks offered just ahead of the cycle, the feed changed and the planner kept
// from its work at any time.

#include <algorithm>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/interpolator/controller.hpp>
#include <leadscrew/planner/planner.hpp>
#include <leadscrew/referee/referee.hpp>
#include <leadscrew/toolpath/builder.hpp>
#include <leadscrew/toolpath/travel.hpp>
#include <optional>
#include <string>
#include <vector>

namespace leadscrew::testing_support {

/// What happens from a tick on: the factor of the feed is another, and the planner does nothing for a while.
struct Intervention {
  std::int64_t tick = 0;
  double factor = 1;
  std::int64_t silence = 0;  ///< ticks
};

class LiveProgram {
 public:
  LiveProgram(std::string text, const machine::Machine& machine, machine::ToolTable tools = {},
              const gcode::ReaderOptions& options = {})
      : machine_(machine),
        text_(std::move(text)),
        tools_(std::move(tools)),
        reader_(gcode::text_source(text_), machine, tools_, options,
                [this](const base::Diagnostic&) { ++diagnostics; }),
        judged_(gcode::text_source(text_), machine, tools_, options, [](const base::Diagnostic&) {}),
        referee_([this](gcode::Move& move) { return judged_.next(move); }, machine, machine.period),
        builder_(machine.rotary_chain ? toolpath::Builder(machine) : toolpath::Builder()),
        planner_(machine, base::AxisVector{}),
        controller_(machine.period, base::AxisVector{}) {
    planner_.slice(0.02);
    if (!machine.threads_follow()) return;
    planner_.follow_spindle();
    builder_.tell_revolutions();
    controller_.follow(*machine.spindle);
  }

  /// Runs to the end, or as many ticks; `words` gets each. False if it has not ended by then.
  bool run(const std::vector<Intervention>& interventions, std::int64_t most_ticks) {
    std::size_t next = 0;
    std::int64_t silent_until = 0;
    for (std::int64_t tick = 0; tick < most_ticks; ++tick) {
      while (next < interventions.size() && interventions[next].tick <= tick) {
        planner_.override_feed(interventions[next].factor);
        silent_until = tick + interventions[next].silence;
        ++next;
      }
      if (tick >= silent_until && !pump() && controller_.idle() && next == interventions.size()) return true;
      const base::Word word = controller_.next();
      referee_.observe(word.position);
      words.push_back(word);
      while (const planner::PlacedEvent* event = controller_.next_event())
        if (base::is_of_program(event->kind)) events.push_back(planner::passed_at(word.tick, *event));
    }
    return false;
  }

  referee::Verdict conclude() { return referee_.conclude(); }
  const constraints::LimitRatios& plan() const { return plan_; }
  const planner::AllowedOverrides& allowed() const { return planner_.allowed_overrides(); }
  std::int64_t refused_windows() const { return planner_.refused_windows(); }
  std::int64_t late = 0;
  double longest_wait = 0;       ///< s of motion handed out before a change of the feed was planned
  std::int64_t diagnostics = 0;  ///< of the reader

  std::vector<base::Word> words;
  std::vector<base::PassedEvent> events;

 private:
  /// Keeps two slices ahead. False if there is nothing more to come.
  bool pump() {
    while (controller_.seconds_ahead() < 0.02) {
      if (!chunk_ && !(chunk_ = plan_next())) return false;
      switch (controller_.offer(*chunk_)) {
        case interpolator::Controller::Offer::accepted:
          chunk_.reset();
          break;
        case interpolator::Controller::Offer::late:
          ++late;
          planner_.refuse();
          chunk_.reset();
          break;
        case interpolator::Controller::Offer::full:
          return true;
        case interpolator::Controller::Offer::unchecked:
          return false;
      }
    }
    return true;
  }

  std::optional<planner::Chunk> plan_next() {
    if (machine_.threads_follow()) planner_.spindle_turns(controller_.spindle_speed());
    std::optional<planner::Chunk> chunk = planner_.pop();
    while (!chunk && reading_) {
      gcode::Move move;
      reading_ = reader_.next(move);
      reading_ ? builder_.push(move) : builder_.finish();
      while (std::optional<toolpath::Element> element = builder_.pop()) {
        if (auto* piece = std::get_if<toolpath::Piece>(&*element)) toolpath::check_travel(*piece, machine_, {}, 1);
        planner_.push(*element);
      }
      if (!reading_) planner_.finish();
      chunk = planner_.pop();
    }
    if (chunk) {
      waiting_ = planner_.change_waits() ? waiting_ + chunk->duration.value() : 0;
      longest_wait = std::max(longest_wait, waiting_);
      planner::raise_limit_ratios(*chunk, machine_, plan_);
      planner::Chunk tail = *chunk;
      tail.segments = tail.stop_tail;
      planner::raise_limit_ratios(tail, machine_, plan_);
    }
    return chunk;
  }

  const machine::Machine& machine_;
  const std::string text_;
  machine::ToolTable tools_;
  gcode::Reader reader_, judged_;
  referee::Referee referee_;
  toolpath::Builder builder_;
  planner::Planner planner_;
  interpolator::Controller controller_;
  std::optional<planner::Chunk> chunk_;
  constraints::LimitRatios plan_{};
  bool reading_ = true;
  double waiting_ = 0;
};

}  // namespace leadscrew::testing_support
