// Blocks per second from text to moves, on one core: a million blocks in memory, of each kind that real programs are
// made of.

#include <benchmark/benchmark.h>

#include <charconv>
#include <cstdint>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/machine/machine.hpp>
#include <percentiles.hpp>
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

std::string lines_with_feed() {  // G1 X12.345 Y-6.789 F1200
  return program([](Walk& w, int) { return "G1 X" + w.step() + " Y" + w.step() + " F1200\n"; });
}
std::string short_lines() {  // X1.2 Y3.4
  return program([](Walk& w, int) { return "X" + w.step() + " Y" + w.step() + "\n"; });
}
std::string numbered_lines() {  // N10 G01 X12.345 Y-6.789 Z1.234
  return program([](Walk& w, int i) {
    return "N" + std::to_string(i) + " G01 X" + w.step() + " Y" + w.step() + " Z" + w.step() + "\n";
  });
}
std::string arcs() {  // half turns there and back
  return program([](Walk&, int i) { return i % 2 ? "G2 X0 Y0 I-5 J0\n" : "G3 X10 Y0 I5 J0\n"; });
}
std::string expressions() {
  return "#1=0\n" + program([](Walk&, int) { return "#1=[#1+0.001] G1 X[10*SIN[#1]]\n"; });
}

void read_made(benchmark::State& state, std::string (*make)()) {
  read(state, make());
}

benchmark::internal::Benchmark* add(const char* name, std::string (*make)()) {
  return leadscrew::bench::with_percentiles(
      benchmark::RegisterBenchmark(name, read_made, make)->Unit(benchmark::kMillisecond)->Iterations(1));
}

auto* const with_feed = add("read/G1 X Y F", lines_with_feed);
auto* const short_ones = add("read/X Y", short_lines);
auto* const numbered = add("read/N G01 X Y Z", numbered_lines);
auto* const round = add("read/arcs", arcs);
auto* const computed = add("read/expressions", expressions);

}  // namespace
