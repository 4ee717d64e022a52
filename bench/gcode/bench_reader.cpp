// Blocks per second from text to moves, on one core: a million blocks in memory, of each kind that real programs are
// made of.

#include <benchmark/benchmark.h>

#include <charconv>
#include <cstdint>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/machine/machine.hpp>
#include <string>

namespace {

using namespace leadscrew;

constexpr int block_count = 1'000'000;

// A walk of small steps inside the travel of the built-in mill; the same on every machine.
class Walk {
 public:
  // The next coordinate with three decimals.
  std::string step() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    const auto micrometres = static_cast<std::int64_t>((state_ >> 33) % 800'001) - 400'000;
    const std::int64_t whole = (micrometres < 0 ? -micrometres : micrometres);
    std::string digits = std::to_string(whole % 1000);
    digits.insert(0, 3 - digits.size(), '0');
    return (micrometres < 0 ? "-" : "") + std::to_string(whole / 1000) + "." + digits;
  }

 private:
  std::uint64_t state_ = 1;
};

template <class Line>
std::string program(Line&& line) {
  std::string text = "G21 G90 G17\nG1 F1200\n";
  Walk walk;
  for (int i = 0; i < block_count; ++i) text += line(walk, i);
  return text + "M2\n";
}

void read(benchmark::State& state, const std::string& text) {
  const machine::Machine mill = machine::mill3();
  const machine::ToolTable tools;
  std::int64_t blocks = 0;
  for (auto _ : state) {
    gcode::Reader reader(gcode::text_source(text), mill, tools, {},
                         [&](const base::Diagnostic& d) { state.SkipWithError(d.message.c_str()); });
    gcode::Move move;
    while (reader.next(move)) benchmark::DoNotOptimize(move);
    blocks += reader.blocks();
  }
  state.SetItemsProcessed(blocks);
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(text.size()));
}

// G1 X12.345 Y-6.789 F1200
void BM_LinesWithFeed(benchmark::State& state) {
  read(state, program([](Walk& w, int) { return "G1 X" + w.step() + " Y" + w.step() + " F1200\n"; }));
}
// X1.2 Y3.4
void BM_ShortLines(benchmark::State& state) {
  read(state, program([](Walk& w, int) { return "X" + w.step() + " Y" + w.step() + "\n"; }));
}
// N10 G01 X12.345 Y-6.789 Z1.234
void BM_NumberedLinesInSpace(benchmark::State& state) {
  read(state, program([](Walk& w, int i) {
         return "N" + std::to_string(i) + " G01 X" + w.step() + " Y" + w.step() + " Z" + w.step() + "\n";
       }));
}
// Half turns there and back
void BM_Arcs(benchmark::State& state) {
  read(state, program([](Walk&, int i) { return i % 2 ? "G2 X0 Y0 I-5 J0\n" : "G3 X10 Y0 I5 J0\n"; }));
}
// #1=[#1+0.001] G1 X[10*SIN[#1]]
void BM_Expressions(benchmark::State& state) {
  read(state, "#1=0\n" + program([](Walk&, int) { return "#1=[#1+0.001] G1 X[10*SIN[#1]]\n"; }));
}

BENCHMARK(BM_LinesWithFeed)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ShortLines)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_NumberedLinesInSpace)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Arcs)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Expressions)->Unit(benchmark::kMillisecond);

}  // namespace
