// Blocks read, smoothed and planned per second, on one core: all that comes before the words.

#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/gcode/tool_table.hpp>
#include <leadscrew/planner/planner.hpp>
#include <leadscrew/toolpath/builder.hpp>
#include <percentiles.hpp>
#include <string>
#include <trunnion.hpp>

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

std::string text_of(const std::string& name) {
  std::ifstream file(std::string(LEADSCREW_SOURCE_DIR) + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A fifth of the patch of the examples, by a ball of 10 mm that leads by 8 degrees: 40 passes.
std::string passes(const std::string& pattern) {
  const std::string patch = text_of("/examples/17-patch-leaning.ngc");
  return patch.substr(0, patch.find("T5 M6")) + "T4 M6\nG43.4 H4\nG0 Z30\nG6.5 D1 A8 H0.0025 J0.2 " + pattern +
         " Z30 F3000\nM2\n";
}

/// "share": of the time that the motion takes; "per motion": blocks per second of motion; "first": s until there is the first
/// chunk of motion.
void prepare(benchmark::State& state, const std::string& text, const machine::Machine& machine) {
  const machine::ToolTable tools = gcode::read_tool_table(text_of("/examples/tools.tbl"), "tools.tbl").table;
  std::int64_t blocks = 0;
  double motion = 0, first = 0;
  for (auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    bool is_begun = false;
    gcode::Reader reader(gcode::text_source(text), machine, tools, {}, [&](const base::Diagnostic& d) {
      if (d.severity == base::Severity::error) state.SkipWithError(d.message.c_str());
    });
    toolpath::Builder builder = machine.rotary_chain ? toolpath::Builder(machine) : toolpath::Builder();
    planner::Planner planner(machine, {});
    const auto plan = [&] {
      while (const std::optional<toolpath::Element> element = builder.pop()) planner.push(*element);
      while (const std::optional<planner::Chunk> chunk = planner.pop()) {
        motion += chunk->duration.value();
        if (is_begun) continue;
        is_begun = true;
        first += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      }
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
  state.counters["first"] = benchmark::Counter(first, benchmark::Counter::kAvgIterations);
  state.counters["share"] = benchmark::Counter(motion, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

const std::string long_program = beginning_of(LEADSCREW_SOURCE_DIR "/out/long-program.ngc", 3000);

void add(const std::string& name, const std::string& text, const machine::Machine& machine = wide_mill()) {
  leadscrew::bench::with_percentiles(
      benchmark::RegisterBenchmark(("prepare/" + name).c_str(), [=](benchmark::State& state) {
        prepare(state, text, machine);
      })->Iterations(1));
}

const bool added = [] {
  add("lines of 5 µm", wave(0.005));
  add("lines of 5 µm, feeds differ", wave(0.005, Feeds::differing));
  add("lines of 0.1 mm", wave(0.1));
  if (long_program.size() >= 100) add("a slicer's program", long_program);
  const machine::Machine trunnion = testing_support::trunnion();
  add("surface in 40 passes, five axes", passes("S2"), trunnion);
  add("surface in 40 passes of one ridge, five axes", passes("S4"), trunnion);
  return true;
}();

}  // namespace
