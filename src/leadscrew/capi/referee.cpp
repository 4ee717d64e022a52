// The calls of leadscrew.h for the referee: a program is read once more beside the words that are judged by it.

#include <leadscrew/referee/referee.hpp>
#include <optional>
#include <string>
#include <utility>

#include "program_readings.hpp"

using namespace leadscrew;
using namespace leadscrew::capi;

/// The reader and the referee look into what is kept here.
struct leadscrew_referee {
  leadscrew_referee(machine::Machine of, std::string text, host::MotionOptions options)
      : machine(std::move(of)),
        readings(machine, std::move(text), std::move(options)),
        reader(readings.open()),
        judge([this](gcode::Move& move) { return !readings.error() && reader.next(move); }, machine, machine.period,
              [this] { return readings.is_ended(); }) {}
  leadscrew_referee(const leadscrew_referee&) = delete;
  leadscrew_referee& operator=(const leadscrew_referee&) = delete;

  /// What ends the judgement, where something does.
  const std::optional<base::Diagnostic>& problem() {
    readings.take(reader);
    return readings.error();
  }

  machine::Machine machine;
  ProgramReadings readings;
  gcode::Reader reader;
  referee::Referee judge;
  bool is_concluded = false;
};

namespace {

leadscrew_judged judged_of(const referee::MatchedBlock& from) {
  auto judged = of_line<leadscrew_judged>(from.line);
  judged.visit = base::visit(from.line);
  judged.distance = from.distance;
  judged.tolerance = from.tolerance;
  return judged;
}

leadscrew_verdict verdict_of(const referee::Verdict& from) {
  return {sizeof(leadscrew_verdict), from.deviation_mm, from.tolerance_mm,
          from.start_error_mm,       from.end_error_mm, from.violation_count};
}

}  // namespace

int leadscrew_referee_begin(const leadscrew_machine* machine, const char* text, size_t length,
                            const leadscrew_options* options, leadscrew_referee** referee, leadscrew_error* error) {
  if (machine == nullptr || referee == nullptr || !is_text(text, length))
    return misuse(
        error, "the machine, the text or the place for the referee is NULL, or the length is none that memory holds");
  return guarded(error, [&] {
    leadscrew_options asked{};
    host::MotionOptions reading;
    if (const int code = read_options(options, machine->machine, asked, reading, error); code != LEADSCREW_OK)
      return code;
    *referee = new leadscrew_referee(machine->machine, std::string(text, length), std::move(reading));
    return static_cast<int>(LEADSCREW_OK);
  });
}

int leadscrew_referee_observe(leadscrew_referee* referee, const leadscrew_word* word, size_t word_size,
                              leadscrew_judged* judged, leadscrew_error* error) {
  if (referee == nullptr || word == nullptr || word_size < sizeof(leadscrew_word) || referee->is_concluded)
    return misuse(error, "the referee or the word is NULL, its size is none that a version had, or all is concluded");
  if (judged != nullptr && !fill(judged, judged_of({})))
    return misuse(error, "the size of what is judged is none that a version had");
  return guarded(error, [&] {
    referee->judge.observe(axes_of(word->position), word->feed >= 0 ? std::optional(word->feed) : std::nullopt);
    if (const auto& problem = referee->problem()) return rejected(error, *problem);
    fill(judged, judged_of(referee->judge.matched()));
    return static_cast<int>(LEADSCREW_OK);
  });
}

int leadscrew_referee_conclude(leadscrew_referee* referee, leadscrew_verdict* verdict, leadscrew_error* error) {
  if (referee == nullptr || referee->is_concluded)
    return misuse(error, "the referee is NULL, or has been asked for its verdict before");
  if (!fill(verdict, verdict_of({})))
    return misuse(error, "the verdict is NULL, or its size is none that a version had");
  return guarded(error, [&] {
    referee->is_concluded = true;
    const referee::Verdict found = referee->judge.conclude();
    if (const auto& problem = referee->problem()) return rejected(error, *problem);
    fill(verdict, verdict_of(found));
    return static_cast<int>(LEADSCREW_OK);
  });
}

void leadscrew_referee_free(leadscrew_referee* referee) {
  delete referee;
}
