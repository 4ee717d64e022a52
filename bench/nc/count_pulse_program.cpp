// One of the pulsed programs by one of the methods, run so many times: for those who count its instructions
// (script/bench).
//
//   count_pulse_program            names them
//   count_pulse_program NAME RUNS  runs it; prints the pulses it made

#include <cstdlib>
#include <pulse_programs.hpp>
#include <string_view>

int main(int count, char** arguments) {
  using namespace leadscrew;
  const std::string_view wanted = count > 1 ? arguments[1] : "";
  const long runs = count > 2 ? std::atol(arguments[2]) : 0;
  for (const bench::PulsedProgram& program : bench::pulsed_programs()) {
    for (const nc::PulseMethod method : nc::all_pulse_methods) {
      const std::string name = bench::name(program, method);
      if (wanted.empty()) std::puts(name.c_str());
      if (name != wanted) continue;
      bench::Stepped sum;
      for (long run = 0; run < runs; ++run) {
        const bench::Stepped stepped = bench::run(program, method);
        sum.pulses += stepped.pulses;
        sum.sum += stepped.sum;
      }
      std::printf("%lld\n", static_cast<long long>(sum.pulses));
      if (sum.sum == 1) std::puts("");  // it has to be calculated
    }
  }
}
