#pragma once
// A program run on time, in this process.

#include <cmath>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/realtime/runner.hpp>
#include <leadscrew/realtime/schedule.hpp>
#include <leadscrew/realtime/word_stream.hpp>
#include <leadscrew/referee/referee.hpp>
#include <memory>
#include <string>
#include <thread>
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

/// What `leadscrew drive` asks of its runner, where nobody says otherwise.
inline realtime::RunnerOptions as_drive(const machine::Machine& machine) {
  return {.period = machine.period,
          .look_ahead = 0.32,
          .lead = std::llround(0.1 / machine.period.seconds()),
          .slice = std::llround(0.02 / machine.period.seconds())};
}

class Live {
 public:
  std::vector<base::Word> words;          ///< the cyclic thread's, until it has ended
  std::vector<base::PassedEvent> events;  ///< likewise

  /// A sink that is not given is `words`.
  Live(const std::string& text, const machine::Machine& machine, Delay delay, const realtime::RunnerOptions& options,
       std::optional<realtime::WordSink> sink = {})
      : source_(gcode::text_source(text), machine, tools_, {}, nullptr),
        runner_(options,
                {.next =
                     [this, delay] {
                       if (delay) delay();
                       return source_.next();
                     },
                 .refuse = [this] { source_.planner().refuse(); },
                 .override_feed = [this](double factor) { source_.planner().override_feed(factor); }},
                sink ? *sink : into_words()) {
    source_.planner().slice(0.02);
    words.reserve(1'000'000);
  }
  Live(const std::string& text, const machine::Machine& machine, Delay delay = {}, double look_ahead = 0.2)
      : Live(text, machine, std::move(delay), {.period = machine.period, .look_ahead = look_ahead}) {}

  realtime::Runner& runner() { return runner_; }
  /// Until the last word has been made.
  void wait() {
    while (!runner_.has_ended()) realtime::sleep_until(realtime::now() + 1'000'000);
  }

 private:
  realtime::WordSink into_words() {
    return {.take =
                [this](const base::Word& word) {
                  words.push_back(word);
                  return true;
                },
            .append_stop_position = {},
            .publish = {},
            .event =
                [this](const base::PassedEvent& event) {
                  events.push_back(event);
                  return true;
                }};
  }

  machine::ToolTable tools_;
  pipeline::MotionSource source_;
  realtime::Runner runner_;
};

/// Drives in a thread: a word a period by a clock of their own; without one, the stop path.
class Drives {
 public:
  std::vector<base::Word> words;            ///< taken
  std::vector<base::AxisVector> stop_path;  ///< to rest, because words ceased

  explicit Drives(base::Period period) : period_(period) {
    words.reserve(1'000'000);
    stop_path.reserve(longest_stop_path);
  }
  ~Drives() { end(); }

  realtime::WordSink sink() {
    return {
        .take = [this](const base::Word& word) { return stream_->push(word); },
        .append_stop_position = [this](const base::PathPlace& place) { return stream_->append_stop_position(place); },
        .publish =
            [this] {
              if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
              return stream_->publish();
            }};
  }
  /// Until all words have been taken: when there will be no more.
  void end() {
    ended_.store(true);
    if (thread_.joinable()) thread_.join();
  }

 private:
  static constexpr std::size_t longest_stop_path = 4096;

  void run() {
    for (std::int64_t wake = realtime::now();; wake += period_.nanoseconds) {
      realtime::sleep_until(wake);
      const bool ends = ended_.load();
      base::Word word;
      if (stream_->pop(word)) {
        words.push_back(word);
        continue;
      }
      if (ends) return;
      const bool stands = words.empty() || words.back().state == base::MotionState::rest;
      if (!stands && stream_->leave_if_empty()) break;
    }
    for (base::PathPlace place; stream_->follow_stop_path(place);) stop_path.push_back(place.position);
  }

  const base::Period period_;
  std::unique_ptr<realtime::WordStream<4096, longest_stop_path>> stream_ =
      std::make_unique<realtime::WordStream<4096, longest_stop_path>>();
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

}  // namespace leadscrew::testing_support
