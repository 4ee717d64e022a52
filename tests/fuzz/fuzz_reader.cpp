// Any bytes are a program: the reader ends, keeps its promises about moves, and gives the same whatever the chunks.
//
//     clang++-19 build with -DLEADSCREW_FUZZ=ON, then: fuzz_reader -max_total_time=60 [corpus]

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/gcode/tool_table.hpp>
#include <leadscrew/machine/machine.hpp>
#include <string_view>

#include "curve_promises.hpp"

namespace {

using namespace leadscrew;

constexpr int most_moves = 2000;  // a canned cycle may be repeated for long

void expect(bool holds) {
  if (!holds) std::abort();
}

machine::Machine machine_with_rotary_axes() {
  machine::Machine machine = machine::mill3();
  for (const base::Axis axis : {base::Axis::A, base::Axis::C}) {
    machine.axes[base::index(axis)] = {-360, 360, 100, 500, 5000, 0.001};
  }
  return machine;
}

gcode::ByteSource in_chunks(std::string_view text, std::size_t size) {
  return [text, size](std::span<char> buffer) mutable -> base::Result<std::size_t> {
    const std::size_t count = std::min({size, buffer.size(), text.size()});
    if (count > 0) std::memcpy(buffer.data(), text.data(), count);
    text.remove_prefix(count);
    return count;
  };
}

struct Summary {
  int moves = 0;
  std::int64_t diagnostics = 0;
  double sum = 0;
  bool operator==(const Summary&) const = default;
};

Summary read(gcode::ByteSource source, const machine::Machine& machine, const machine::ToolTable& tools,
             gcode::Dialect dialect) {
  Summary summary;
  gcode::ReaderOptions options;
  options.file = "fuzz.ngc";
  options.dialect = dialect;
  options.fuel = 5000;
  gcode::Reader reader(std::move(source), machine, tools, options, [&](const base::Diagnostic& d) {
    ++summary.diagnostics;
    expect(!d.code.empty() && !d.message.empty() && d.place.line >= 1 && d.place.column >= 1);
  });
  gcode::Move move;
  base::AxisVector position{};
  for (; summary.moves < most_moves && reader.next(move); ++summary.moves) {
    // Blocks with a problem leave gaps; without one, moves join.
    if (reader.errors() == 0) expect(move.start == position);
    position = move.end;
    for (const base::Axis axis : base::all_axes) {
      const double x = move.end[base::index(axis)];
      expect(std::isfinite(x));
      if (machine.has(axis) && move.kind != gcode::Move::Kind::event && move.kind != gcode::Move::Kind::dwell) {
        expect(machine.limits(axis).travel_min - 1e-6 <= x && x <= machine.limits(axis).travel_max + 1e-6);
      }
      summary.sum += x;
    }
    if (move.kind == gcode::Move::Kind::arc) {
      const std::size_t i = base::index(gcode::first_axis(move.plane)), k = base::index(gcode::second_axis(move.plane));
      const double from = std::hypot(move.start[i] - move.center_first, move.start[k] - move.center_second);
      const double to = std::hypot(move.end[i] - move.center_first, move.end[k] - move.center_second);
      expect(move.turns != 0 && from > 0);
      expect(std::fabs(from - to) <= 1e-12 * (1000 + from));
    }
    expect(gcode::keeps_promises_of_curve(move));
    if (move.kind == gcode::Move::Kind::nurbs) {
      // The definition takes time by the square of the number of points.
      expect(move.curve.points.size() > 50 || gcode::curve_is_inside(move, machine, 30));
      for (const gcode::ControlPoint& point : move.curve.points) summary.sum += point.weight + point.position[0];
      for (const double knot : move.curve.knots) summary.sum += knot;
    }
    if (move.kind == gcode::Move::Kind::line || move.kind == gcode::Move::Kind::arc) {
      expect((move.feed.mode == gcode::Feed::Mode::rapid) || move.feed.value > 0);
    }
  }
  expect(summary.moves + summary.diagnostics > 0);
  return summary;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const machine::Machine machine = machine_with_rotary_axes();
  static const machine::ToolTable tools(
      std::vector<machine::Tool>{{1, 0, {0, 0, 10}, 0, {}}, {2, 0, {1, 2, 3}, 0, {}}});
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto dialect = static_cast<gcode::Dialect>(size % index(gcode::Dialect::count));
  expect(read(gcode::text_source(text), machine, tools, dialect) == read(in_chunks(text, 7), machine, tools, dialect));
  (void)gcode::read_tool_table(text, "fuzz.tbl");
  return 0;
}
