// Blocks read, smoothed and planned per second, on one core: all that comes before the words.

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/planner/planner.hpp>
#include <leadscrew/toolpath/builder.hpp>
#include <percentiles.hpp>
#include <string>

namespace {

using namespace leadscrew;

machine::Machine wide_mill() {
  machine::Machine machine = machine::mill3();
  for (auto& axis : machine.axes) {
    if (axis) axis->travel_min = -1e5, axis->travel_max = 1e5;
  }
  return machine;
}

enum class Feeds : std::uint8_t { one, differing };

/// 400 mm of a wave in lines of this length, mm, at 6000 mm/min, or each at a feed of its own down to half of that.
std::string wave(double length, Feeds feeds = Feeds::one) {
  constexpr double distance = 400;
  std::string text = "G21 G90 G17 G94 F6000 G64 P0.01\n";
  double x = 0, y = 0;
  std::uint64_t state = 1;
  for (double s = 0; s < distance; s += length) {
    const double slope = 0.8 * std::sin(s / 7);
    x += length * std::cos(slope), y += length * std::sin(slope);
    // A linear congruence, for feeds that do not repeat.
    state = state * 6364136223846793005u + 1442695040888963407u;
    const double feed = feeds == Feeds::one ? 6000 : 6000 - 3000 * (static_cast<double>(state >> 40) / 0x1p24);
    char line[64];
    std::snprintf(line, sizeof line, "G1 X%.6f Y%.6f F%.0f\n", x, y, feed);
    text += line;
  }
  return text + "M2\n";
}

/// The first blocks of a file; nothing if there is none.
std::string beginning_of(const std::string& name, int blocks) {
  std::ifstream file(name);
  std::string text = "G64 P0.01\n", line;
  while (blocks-- > 0 && std::getline(file, line)) text += line + '\n';
  return text + "M2\n";
}

/// "share": of the time that the motion takes; "per motion": blocks per second of motion.
void prepare(benchmark::State& state, const std::string& text) {
  const machine::Machine machine = wide_mill();
  const machine::ToolTable tools;
  std::int64_t blocks = 0;
  double motion = 0;
  for (auto _ : state) {
    gcode::Reader reader(gcode::text_source(text), machine, tools, {},
                         [&](const base::Diagnostic& d) { state.SkipWithError(d.message.c_str()); });
    toolpath::Builder builder;
    planner::Planner planner(machine, {});
    const auto plan = [&] {
      while (const std::optional<toolpath::Element> element = builder.pop()) planner.push(*element);
      while (const std::optional<planner::Chunk> chunk = planner.pop()) motion += chunk->duration.value();
    };
    gcode::Move move;
    while (reader.next(move)) {
      builder.push(move);
      plan();
    }
    builder.finish();
    plan();
    planner.finish();
    plan();
    blocks += reader.blocks();
  }
  state.SetItemsProcessed(blocks);
  state.counters["per_motion_s"] = static_cast<double>(blocks) / motion;
  state.counters["share"] = benchmark::Counter(motion, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

const std::string long_program = beginning_of(LEADSCREW_SOURCE_DIR "/out/long-program.ngc", 3000);

auto* const fine = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("prepare/lines of 5 µm", prepare, wave(0.005))->Iterations(1));
auto* const differing = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("prepare/lines of 5 µm, feeds differ", prepare, wave(0.005, Feeds::differing))
        ->Iterations(1));
auto* const coarse = leadscrew::bench::with_percentiles(
    benchmark::RegisterBenchmark("prepare/lines of 0.1 mm", prepare, wave(0.1))->Iterations(1));
auto* const sliced =
    long_program.size() < 100
        ? nullptr
        : leadscrew::bench::with_percentiles(
              benchmark::RegisterBenchmark("prepare/a slicer's program", prepare, long_program)->Iterations(1));

}  // namespace
