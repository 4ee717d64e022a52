// Any program on any machine: its words keep the machine's limits, the program's geometry and its end, by the plan and by
// the referee. The input's first bytes are the machine, each of the following ones a word of the program or its number:
// few texts are programs, and fuzz_reader sees to all others.
//
//     clang++-19 build with -DLEADSCREW_FUZZ=ON, then: fuzz_pipeline -max_total_time=60 [corpus]

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/referee/referee.hpp>
#include <string>
#include <worst_ratios.hpp>

namespace {

using namespace leadscrew;

constexpr int most_blocks = 24;
constexpr int most_words = 20'000;
constexpr int most_looks = 2000;  // every few milliseconds of planning and judging: what takes longer is given up

void expect(bool holds, const char* what, double value) {
  if (holds) return;
  std::fprintf(stderr, "%s: %.17g\n", what, value);
  std::abort();
}

/// Numbers out of the input; 0 behind its end.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : next_(data), left_(size) {}

  bool is_empty() const { return left_ == 0; }
  int byte() {
    if (left_ == 0) return 0;
    --left_;
    return *next_++;
  }
  double logarithmic(double least, double greatest) { return least * std::pow(greatest / least, byte() / 255.0); }
  /// Of either sign: 0, 1 µm … 31 mm, most of them of a few millimetres.
  double length() {
    const int size = byte(), digits = byte();
    if (size == 0) return 0;
    const double magnitude = (size & 0x7f) < 16 ? digits * 1e-3 : (size & 0x7f) * 0.25 + digits * 1e-3;
    return size & 0x80 ? -magnitude : magnitude;
  }

 private:
  const std::uint8_t* next_;
  std::size_t left_;
};

/// Limits over three decades, a period of 0.1 … 20 ms.
machine::Machine machine_of(Input& input) {
  machine::Machine machine;
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z, base::Axis::A}) {
    machine.axes[base::index(axis)] = machine::AxisLimits{
        -1e4, 1e4, input.logarithmic(5, 5000), input.logarithmic(30, 3e4), input.logarithmic(500, 3e6), 0.001};
  }
  machine.period = {std::llround(input.logarithmic(1e5, 20e6))};
  return machine;
}

std::string word(char letter, double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%c%.3f ", letter, value);
  return text;
}

/// In relative coordinates, so that every end is a place to go on from.
std::string block_of(Input& input) {
  const auto xy = [&] { return word('X', input.length()) + word('Y', input.length()); };
  switch (input.byte() % 12) {
    case 0:
      return "G0 " + xy() + word('Z', input.length());
    case 1:
    case 2:
    case 3:
      return "G1 " + xy();
    case 4:
      return "G1 " + xy() + word('Z', input.length()) + word('A', input.length());
    case 5: {  // at least half as far from the start as the end is: a radius that reaches
      const double x = input.length(), y = input.length(), radius = std::hypot(x, y) * (0.5005 + input.byte() / 64.0);
      return (input.byte() % 2 ? "G2 " : "G3 ") + word('X', x) + word('Y', y) + word('R', radius + 0.001);
    }
    case 6:  // whole circles, and helices
      return (input.byte() % 2 ? "G2 " : "G3 ") + word('I', input.length()) + word('J', input.length()) +
             word('Z', input.length()) + "P" + std::to_string(1 + input.byte() % 3);
    case 7:
      return "G5 " + xy() + word('I', input.length()) + word('J', input.length()) + word('P', input.length()) +
             word('Q', input.length());
    case 8:
      return word('F', input.logarithmic(6, 60000));
    case 9:
      return input.byte() % 3 ? "G64 " + word('P', input.logarithmic(0.001, 1)) : "G61.1";
    case 10:
      return "G4 " + word('P', input.byte() * 1e-3);
    default:
      return "G1 " + word('X', input.length());
  }
}

std::string program_of(Input& input) {
  std::string text = "G21 G91 G17 G94 F600\n";
  for (int block = 0; block < most_blocks && !input.is_empty(); ++block) text += block_of(input) + "\n";
  return text + "M2\n";
}

bool has_error(const std::string& text, const machine::Machine& machine, const machine::ToolTable& tools) {
  gcode::Reader reader(gcode::text_source(text), machine, tools, {}, [](const base::Diagnostic&) {});
  gcode::Move move;
  while (reader.next(move)) {
  }
  return reader.errors() > 0;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input input(data, size);
  const machine::Machine machine = machine_of(input);
  const std::string text = program_of(input);
  const machine::ToolTable tools;
  if (has_error(text, machine, tools)) return 0;

  int looks = 0;
  const auto is_over = [&looks] { return ++looks > most_looks; };
  const auto ignore = [](const base::Diagnostic&) {};
  pipeline::Program program(gcode::text_source(text), machine, tools, {}, ignore);
  program.stop_when(is_over);
  gcode::Reader judged(gcode::text_source(text), machine, tools, {}, ignore);
  referee::Referee referee([&](gcode::Move& move) { return judged.next(move); }, machine, machine.period, is_over);
  int words = 0;
  bool goes_on = false;
  while (words < most_words && (goes_on = program.prepare())) {
    referee.observe(program.cycle().position);
    ++words;
  }
  const pipeline::Summary& summary = program.summary();
  expect(testing_support::worst_planned(summary.plan) <= 1 + 1e-9, "planned over limit", summary.plan.greatest());
  if (program.failure() && program.failure()->code != "interrupted") {
    std::fprintf(stderr, "%s\n", program.failure()->message.c_str());
    std::abort();
  }
  if (goes_on || looks > most_looks || program.failure()) return 0;
  const referee::Verdict verdict = referee.conclude();
  if (looks > most_looks) return 0;
  for (const referee::Violation& violation : verdict.violations) {
    std::fprintf(stderr, "%s%.6f s: %s\n", text.c_str(), violation.t, violation.what.c_str());
    expect(false, "violation", violation.value / violation.limit);
  }
  expect(testing_support::worst_judged(verdict) <= 1.001, "over limit", testing_support::worst_judged(verdict));
  expect(verdict.end_error_mm <= 1e-9, "error at the end", verdict.end_error_mm);
  expect(summary.bound_s <= summary.time_s * (1 + 1e-6), "faster than its bound", summary.bound_s / summary.time_s);
  return 0;
}
