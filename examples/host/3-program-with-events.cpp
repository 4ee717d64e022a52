// A part program for a controller: words to the drives, events to the machine, and a hold while the spindle gains speed.
#include <array>
#include <cstdio>
#include <leadscrew/motion.hpp>

#include "trace_file.hpp"

using namespace leadscrew;

static const char* const program = R"(G21 G90 G17 G64 P0.01
T2 M6
S8000 M3
G0 X10 Y5
M8
G1 X60 F3000
G3 X60 Y45 J20
G1 X10
M9
G0 X0 Y0
M5
M2
)";

int main(int argc, char** argv) {
  TraceFile trace(argc, argv, "XYZ", machine::mill3().period);
  bool holds = false;
  host::MotionOptions options;
  // With the word in whose period it happens: motion rests for M3 and M6, coolant is switched on the way.
  options.on_event = [&](const base::PassedEvent& event) {
    std::printf("%7.3f s  line %2lld  %s\n", static_cast<double>(base::count(event.tick)) * 1e-3,
                static_cast<long long>(base::number(event.line)), std::string(base::code_of(event)).c_str());
    if (event.kind == base::Event::Kind::spindle_clockwise) holds = true;
  };
  auto motion = host::Motion::of_program(machine::mill3(), program, options);
  if (!motion) return std::fprintf(stderr, "%s\n", motion.error().message.c_str()), 1;

  std::array<base::Word, 1> word;  // one a period, as a cycle takes them
  for (;;) {
    if ((*motion)->next(word) > 0) {
      trace.write(word[0]);  // and to the drives
      if (holds) (void)(*motion)->override_feed(0);
    } else if ((*motion)->progress() == pipeline::Progress::held) {
      std::puts("           held until the spindle has its speed");
      holds = false;
      (void)(*motion)->override_feed(1);
    } else {
      break;
    }
  }
  std::printf("%7.3f s  end\n", (*motion)->summary().time_s);
}
