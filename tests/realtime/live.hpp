#pragma once
// A program run on time, in this process.

#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/realtime/runner.hpp>
#include <leadscrew/realtime/schedule.hpp>
#include <leadscrew/referee/referee.hpp>
#include <string>
#include <vector>

namespace leadscrew::testing_support {

inline std::vector<base::Word> words_of(const std::string& text, const machine::Machine& machine) {
  const machine::ToolTable tools;
  pipeline::Program program(gcode::text_source(text), machine, tools, {}, nullptr);
  std::vector<base::Word> words;
  while (program.prepare()) words.push_back(program.cycle());
  return words;
}

inline referee::Verdict judge(const std::string& text, const machine::Machine& machine,
                              const std::vector<base::Word>& words) {
  const machine::ToolTable tools;
  gcode::Reader reader(gcode::text_source(text), machine, tools, {}, nullptr);
  referee::Referee referee([&](gcode::Move& move) { return reader.next(move); }, machine, machine.period);
  for (const base::Word& word : words) referee.observe(word.position);
  return referee.conclude();
}

/// What keeps the planner from its work before it plans a chunk.
using Delay = std::function<void()>;

class Live {
 public:
  std::vector<base::Word> words;  ///< the cyclic thread's, until it has ended

  Live(const std::string& text, const machine::Machine& machine, Delay delay = {}, double look_ahead = 0.2)
      : source_(gcode::text_source(text), machine, tools_, {}, nullptr),
        runner_(options(machine, look_ahead),
                {.next =
                     [this, delay] {
                       if (delay) delay();
                       return source_.next();
                     },
                 .refuse = [this] { source_.planner().refuse(); },
                 .override_feed = [this](double factor) { source_.planner().override_feed(factor); }},
                {.take =
                     [this](const base::Word& word) {
                       words.push_back(word);
                       return true;
                     },
                 .lead_on = {},
                 .publish = {}}) {
    source_.planner().slice(0.02);
    words.reserve(1'000'000);
  }

  realtime::Runner& runner() { return runner_; }
  /// Until the last word has been made.
  void wait() {
    while (!runner_.has_ended()) realtime::sleep_until(realtime::now() + 1'000'000);
  }

 private:
  static realtime::RunnerOptions options(const machine::Machine& machine, double look_ahead) {
    return {.period = machine.period, .look_ahead = look_ahead};
  }

  machine::ToolTable tools_;
  pipeline::MotionSource source_;
  realtime::Runner runner_;
};

}  // namespace leadscrew::testing_support
