// One of the reference-pulse interpolators, run so many times: for those who count its instructions (script/bench).
//
//   count_pulse            names them
//   count_pulse NAME RUNS  runs it; prints the clocks it took

#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "pulse_cases.hpp"

int main(int count, char** arguments) {
  using namespace leadscrew;
  const std::string_view wanted = count > 1 ? arguments[1] : "";
  const long runs = count > 2 ? std::atol(arguments[2]) : 0;
  bench::for_each_pulse_case([&](std::string_view name, auto make) {
    if (wanted.empty()) std::printf("%s\n", name.data());
    if (name != wanted) return;
    std::int64_t clocks = 0;
    pulse::Point sum;
    for (long run = 0; run < runs; ++run) clocks += bench::run(make(), sum);
    std::printf("%lld\n", static_cast<long long>(clocks));
    if (sum.x == runs && sum.y == runs) std::puts("");  // it has to be calculated
  });
}
