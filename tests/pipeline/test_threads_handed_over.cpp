// Motion in step with a spindle, handed to the cycle in several chunks that wait in its queue: the words of a program that is moved
// chunk by chunk; a stop inside it, a hold, and its end.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/interpolator/controller.hpp>
#include <leadscrew/pipeline/motion_source.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <optional>
#include <string>
#include <vector>

namespace test_threads_handed_over {

using namespace leadscrew;
using interpolator::Controller;

/// Feed, a thread of one line, two passes of three lines and a tap, with feed between and behind.
const std::string text =
    "G21 G90 G18 F3000\nM3 S600\nG1 X5.5 Z2\nG33 Z-4 K1.5\nG1 X6\nZ2\nX5\nG76 P2 Z-6 I-0.5 J0.4 K0.6 R1 Q29.5 E1 L3\n"
    "G17 G1 X7 Z0\nG33.1 Z-6 K1\nG1 X12\nY4\nX6\nM2\n";

/// From one word at which something is asked to the next, each in a run of its own.
constexpr std::size_t stride = 199;

machine::Machine lathe() {
  machine::Machine machine = machine::mill3();
  machine.spindle = machine::Spindle{.acceleration = 2000, .wander = 0.05, .wander_period = 3, .seed = 7};
  return machine;
}

/// As many chunks in the queue as it takes; the planner is told nothing of the words.
class Queued {
 public:
  /// capacity: chunks, the one in motion among them.
  explicit Queued(const machine::Machine& machine, std::size_t capacity = 8)
      : machine_(machine),
        controller_(machine_.period, {}, capacity),
        source_(gcode::text_source(text), machine_, tools_, {}, nullptr) {
    source_.follow_spindle();
    source_.planner().slice(0.02);
    controller_.follow(*machine_.spindle);
  }

  Controller& controller() { return controller_; }
  planner::Planner& planner() { return source_.planner(); }
  /// None where motion has ended, or is held.
  std::optional<base::Word> next() {
    fill();
    if (controller_.has_left_step() ? controller_.stands() : controller_.idle()) return std::nullopt;
    const base::Word word = controller_.next();
    while (const planner::PlacedEvent* event = controller_.next_event()) {
      if (base::is_in_step(event->kind)) is_in_step_ = event->value > 0;
    }
    return word;
  }
  /// By the events that have been passed, between the lines of a pass too.
  bool is_in_step() const { return is_in_step_; }
  /// False where there is none.
  bool append_next(std::vector<base::Word>& words) {
    const std::optional<base::Word> word = next();
    if (word) words.push_back(*word);
    return word.has_value();
  }
  /// Lies one behind the chunk in motion?
  bool has_queued() const { return controller_.begun() < accepted_; }

 private:
  void fill() {
    for (;;) {
      if (!offered_ && !(offered_ = source_.next())) return;
      const Controller::Offer offer = controller_.offer(*offered_);
      if (offer == Controller::Offer::full) return;
      EXPECT_EQ(offer, Controller::Offer::accepted);
      ++accepted_;
      offered_.reset();
    }
  }

  const machine::Machine& machine_;
  machine::ToolTable tools_;
  Controller controller_;
  pipeline::MotionSource source_;
  std::optional<planner::Chunk> offered_;
  std::int64_t accepted_ = 0;
  bool is_in_step_ = false;
};

/// Of the program, chunk by chunk.
std::vector<base::Word> plain_words(const machine::Machine& machine) {
  const machine::ToolTable tools;
  pipeline::Program program(gcode::text_source(text), machine, tools, {}, nullptr);
  program.slice(0.02);
  std::vector<base::Word> words;
  while (program.prepare()) words.push_back(program.cycle());
  return words;
}

void expect_same(const base::Word& word, const base::Word& expected) {
  ASSERT_EQ(word.position, expected.position);
  ASSERT_EQ(word.path_length, expected.path_length);
  ASSERT_EQ(word.feed, expected.feed);
  ASSERT_EQ(word.state, expected.state);
}

TEST(ThreadsHandedOver, HaveTheWordsOfTheProgram) {
  const machine::Machine machine = lathe();
  const auto expected = plain_words(machine);
  Queued queued(machine);
  bool was_queued_in_step = false;
  for (const base::Word& word : expected) {
    const std::optional<base::Word> given = queued.next();
    ASSERT_TRUE(given);
    ASSERT_NO_FATAL_FAILURE(expect_same(*given, word)) << base::count(word.tick);
    was_queued_in_step |= queued.controller().is_in_step() && queued.has_queued();
  }
  EXPECT_TRUE(was_queued_in_step);
  EXPECT_FALSE(queued.next());
  EXPECT_EQ(queued.controller().starvations(), 0);
  const interpolator::ThreadFigures threads = queued.controller().threads();
  EXPECT_GT(threads.lines + threads.out_of_step, 5);
}

/// Third differences over the limit of jerk, second over that of acceleration, as if motion stood before and behind.
double worst_ratio(const std::vector<base::Word>& words, const machine::Machine& machine) {
  const double t = machine.period.seconds();
  const auto at = [&](std::size_t k, std::size_t back, std::size_t i) {
    return words[std::min(k < back ? 0 : k - back, words.size() - 1)].position[i];
  };
  double worst = 0;
  for (std::size_t k = 0; k < words.size() + 3; ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      const machine::AxisLimits& limits = *machine.axes[i];
      const double a = at(k, 0, i), b = at(k, 1, i), c = at(k, 2, i), d = at(k, 3, i);
      worst = std::max({worst, std::abs(a - 2 * b + c) / (t * t) / limits.acceleration,
                        std::abs(a - 3 * b + 3 * c - d) / (t * t * t) / limits.jerk});
    }
  }
  return worst;
}

std::vector<base::Word> words_to_rest(interpolator::Interpolator cycle) {
  std::vector<base::Word> words;
  do {
    words.push_back(cycle.next());
  } while (words.back().state != base::MotionState::rest);
  return words;
}

/// Asked at every word from some word on, as by a runner that has been told to stop.
TEST(ThreadsHandedOver, AreLeftAndNothingQueuedIsBegun) {
  const machine::Machine machine = lathe();
  const std::size_t whole = plain_words(machine).size();
  int left_in_motion = 0;
  for (std::size_t from = 0; from < whole; from += stride) {
    SCOPED_TRACE(from);
    Queued queued(machine);
    Controller& controller = queued.controller();
    std::vector<base::Word> words, onward;
    while (words.size() < from) words.push_back(*queued.next());
    if (controller.is_in_step()) onward = words_to_rest(controller.onward());
    std::int64_t begun = -1;
    do {
      controller.leave_step();
      if (begun < 0 && controller.is_in_step()) begun = controller.begun();
    } while (queued.append_next(words));
    EXPECT_LE(worst_ratio(words, machine), 1.001);
    EXPECT_EQ(words.back().state, base::MotionState::rest);
    for (std::size_t k = 0; k < onward.size(); ++k)
      ASSERT_NO_FATAL_FAILURE(expect_same(words[from + k], onward[k])) << k;
    left_in_motion += onward.size() > 1 ? 1 : 0;
    if (begun < 0) continue;
    EXPECT_TRUE(controller.has_left_step());
    EXPECT_EQ(controller.begun(), begun);
  }
  EXPECT_GT(left_in_motion, 5);
}

/// Motion goes on to where it is in step no more, by the same words, though the queue is short and holds not all of a pass by
/// then; and on from rest.
TEST(ThreadsHandedOver, AreCutToTheirEndBeforeMotionIsHeld) {
  const machine::Machine machine = lathe();
  const auto plain = plain_words(machine);
  std::vector<bool> is_in_step;
  std::int64_t lines = 0;
  {
    Queued queued(machine);
    while (queued.next()) is_in_step.push_back(queued.is_in_step());
    lines = queued.controller().threads().lines;
  }
  int held = 0;
  for (std::size_t from = 0; from < plain.size(); from += stride / 2) {
    if (!is_in_step[from]) continue;
    SCOPED_TRACE(from);
    Queued queued(machine, 2);
    std::vector<base::Word> words;
    while (words.size() < from) words.push_back(*queued.next());
    queued.planner().override_feed(0);
    while (queued.append_next(words)) {
    }
    held += words.size() < plain.size() ? 1 : 0;
    const auto end =
        std::size_t(std::find(is_in_step.begin() + std::ptrdiff_t(from), is_in_step.end(), false) - is_in_step.begin());
    ASSERT_GE(words.size(), end);
    for (std::size_t k = 0; k < end; ++k) ASSERT_NO_FATAL_FAILURE(expect_same(words[k], plain[k])) << k;
    queued.planner().override_feed(1);
    while (queued.append_next(words)) {
    }
    EXPECT_EQ(words.back().position, plain.back().position);
    EXPECT_EQ(queued.controller().threads().lines, lines);
    EXPECT_LE(worst_ratio(words, machine), 1.001);
  }
  EXPECT_GT(held, 5);
}

}  // namespace test_threads_handed_over
