// What planning takes beside the motion: sections of one kind each, the path made before, on the built-in mill and on one
// that is ten times as fast.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/planner/planner.hpp>
#include <leadscrew/toolpath/builder.hpp>
#include <memory>
#include <motion.hpp>
#include <numbers>
#include <optional>
#include <percentiles.hpp>
#include <six_axes.hpp>
#include <string>
#include <trunnion.hpp>
#include <vector>

namespace {

using namespace leadscrew;

double thread_cpu_seconds() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

using Path = std::vector<toolpath::Element>;

/// A tenfold acceleration takes a hundredfold jerk to be reached in a tenth of the time.
machine::Machine fast_mill() {
  machine::Machine machine = machine::mill3();
  for (auto& axis : machine.axes) {
    if (axis) axis->acceleration *= 10, axis->jerk *= 100;
  }
  return machine;
}

/// Its lines and corners become paths of least time within the tolerance.
machine::Machine by_least_time(machine::Machine machine) {
  machine.smoothing = machine::Smoothing::least_time;
  return machine;
}

Path path_of(const std::string& text, const machine::Machine& machine = machine::mill3()) {
  const machine::ToolTable tools;
  gcode::Reader reader(gcode::text_source(text), machine, tools, {}, [](const base::Diagnostic&) {});
  const bool asks = machine.rotary_chain || machine.smoothing == machine::Smoothing::least_time;
  toolpath::Builder builder = asks ? toolpath::Builder(machine) : toolpath::Builder();
  Path path;
  const auto take = [&] {
    while (std::optional<toolpath::Element> element = builder.pop()) path.push_back(std::move(*element));
  };
  gcode::Move move;
  while (reader.next(move)) {
    builder.push(move);
    take();
  }
  builder.finish();
  take();
  return path;
}

std::string block(double x, double y) {
  char text[64];
  std::snprintf(text, sizeof text, "G1 X%.4f Y%.4f\n", x, y);
  return text;
}

const std::string start = "G21 G90 G17 G94 F6000 G64 P0.01\n";

std::string squares() {
  std::string text = start;
  for (int k = 0; k < 5; ++k) text += block(10, 0) + block(10, 10) + block(0, 10) + block(0, 0);
  return text + "M2\n";
}
std::string zigzag() {
  std::string text = start;
  for (int k = 0; k < 12; ++k) text += block(k % 2 == 0 ? 10 : 0, 0.5 * k) + block(k % 2 == 0 ? 10 : 0, 0.5 * (k + 1));
  return text + "M2\n";
}
/// Lines of `shortest` to `longest` mm; each turns by up to `turn` rad, one of sixteen anyhow.
std::string wandering(int count, double shortest, double longest, double turn) {
  constexpr double half_turn = 3.14159;
  std::string text = start;
  std::uint64_t state = 1;
  const auto random = [&] {  // 0 … 1, by a linear congruence
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state >> 40) / 0x1p24;
  };
  double x = 0, y = 0, angle = 0;
  for (int k = 0; k < count; ++k) {
    angle += (random() < 1.0 / 16 ? half_turn : turn) * (2 * random() - 1);
    const double length = shortest + (longest - shortest) * random();
    x += length * std::cos(angle), y += length * std::sin(angle);
    text += block(x, y);
  }
  return text + "M2\n";
}

/// Rows of short lines to and fro over a wavy surface.
std::string finishing() {
  constexpr int rows = 17, lines = 52;
  std::string text = start;
  for (int row = 0; row < rows; ++row) {
    for (int k = 0; k <= lines; ++k) {
      const double x = 0.9 * (row % 2 == 0 ? k : lines - k), y = 2 * row;
      char z[32];
      std::snprintf(z, sizeof z, " Z%.4f\n", 3 * std::sin(x / 9) * std::cos(y / 7));
      text += block(x, y);
      text.back() = ' ';
      text += z;
    }
  }
  return text + "M2\n";
}

Path lines_with_stops() {
  Path path;
  for (int k = 0; k < 100; ++k) {
    const double from = 5.0 * (k % 2), to = 5 - from;
    path.emplace_back(testing_support::line_piece({from, from, from}, {to, to, to}, 60));
  }
  return path;
}
Path small_arcs() {
  Path path;
  for (int k = 0; k < 20; ++k) {
    path.emplace_back(testing_support::arc_piece({}, 1, 0, 2 * std::numbers::pi, 100));
    std::get<toolpath::Piece>(path.back()).stop = true;
  }
  return path;
}

/// "longest": s of the longest call; "share": of the time that the motion takes. The same in units of planner::Effort,
/// which no other process disturbs: "most_units" of a call, "units_per_second" of motion.
void plan(benchmark::State& state, const machine::Machine& machine, const geometry::Point& start_point,
          const Path& path) {
  double longest = 0, taken = 0, motion = 0, most_units = 0, all_units = 0;
  for (auto _ : state) {
    planner::Planner planner(machine, start_point);
    double units = 0;
    const auto pop = [&] {
      for (;;) {
        const double before = thread_cpu_seconds();
        const std::optional<planner::Chunk> chunk = planner.pop();
        const double call = thread_cpu_seconds() - before;
        most_units = std::max(most_units, planner.effort() - units);
        units = planner.effort();
        longest = std::max(longest, call);
        taken += call;
        if (!chunk) return;
        motion += chunk->duration.value();
      }
    };
    for (const toolpath::Element& element : path) {
      planner.push(element);
      pop();
    }
    planner.finish();
    pop();
    all_units += units;
  }
  state.counters["longest"] = longest;
  state.counters["share"] = taken / motion;
  state.counters["most_units"] = most_units;
  state.counters["units_per_second"] = all_units / motion;
  state.counters["motion"] = motion;
  state.SetItemsProcessed(static_cast<std::int64_t>(path.size()) * state.iterations());
}

/// The path is made once, where its section is run.
template <typename Make>
void add(const std::string& name, const machine::Machine& machine, const Make& make, const geometry::Point& at = {}) {
  const auto made = std::make_shared<std::optional<Path>>();
  leadscrew::bench::with_percentiles(
      benchmark::RegisterBenchmark(("plan/" + name).c_str(), [=](benchmark::State& state) {
        if (!*made) *made = make();
        plan(state, machine, at, **made);
      })->Iterations(1));
}

const bool added = [] {
  const auto add_all = [](const machine::Machine& machine, const std::string& on) {
    add("corners" + on, machine, [=] { return path_of(squares(), machine); });
    add("zigzag" + on, machine, [=] { return path_of(zigzag(), machine); });
    add("engraving" + on, machine, [=] { return path_of(wandering(200, 0.05, 0.5, 0.6), machine); });
    add("random lines" + on, machine, [=] { return path_of(wandering(40, 0.2, 4, 3), machine); });
    add("finishing" + on, machine, [=] { return path_of(finishing(), machine); });
  };
  for (const bool fast : {false, true}) {
    const machine::Machine machine = fast ? fast_mill() : machine::mill3();
    const std::string on = fast ? ", ten times as fast" : "";
    add("line" + on, machine, lines_with_stops);
    add("small arcs" + on, machine, small_arcs);
    add_all(machine, on);
    add_all(by_least_time(machine), on + ", by least time");
  }
  const machine::Machine trunnion = testing_support::trunnion();
  const auto blade = [](const machine::Machine& on) {
    return path_of(testing_support::blade_program("P0.02 E0.1", 30, 150), on);
  };
  add("blade of 4500 short lines in five axes", trunnion, [=] { return blade(trunnion); });
  machine::Machine like_mill = trunnion;
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z}) {
    auto& limits = like_mill.axes[base::index(axis)];
    const auto of_mill = machine::mill3().axes[base::index(axis)];
    limits->velocity = of_mill->velocity, limits->acceleration = of_mill->acceleration, limits->jerk = of_mill->jerk;
  }
  add("the same with the linear axes of the built-in mill", like_mill, [=] { return blade(like_mill); });
  const auto six_axes = [] {
    testing_support::CurveInSixAxes curve(50);
    Path path;
    while (path.size() < 300) path.emplace_back(curve.next());
    return path;
  };
  add("windows of a curve in six axes", testing_support::mill_of_six_axes(), six_axes,
      testing_support::CurveInSixAxes(50).start());
  return true;
}();

}  // namespace
