
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <charconv>
#include <cmath>
#include <string>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace {

// The shortest decimal that reads back as the same double, without exponent.
std::string decimal(double value) {
  char buffer[400];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed);
  return {buffer, end.ptr};
}

double coordinate() {
  return *rc::gen::inRange(-400'000'000, 400'000'000) / 1e6 / *rc::gen::inRange(1, 100);
}

// Reads at most so many moves, and checks what holds of any of them.
void read_anything(const std::string& text) {
  const machine::Machine machine = nine_axes();
  const machine::ToolTable tools;
  int diagnostics = 0;
  Reader reader(text_source(text), machine, tools, {}, [&](const base::Diagnostic& d) {
    ++diagnostics;
    RC_ASSERT(!d.code.empty());
    RC_ASSERT(d.place.line >= 1);
    RC_ASSERT(d.place.column >= 1);
  });
  Move move;
  int moves = 0;
  base::AxisVector position{};
  for (; moves < 10'000 && reader.next(move); ++moves) {
    if (reader.errors() == 0) RC_ASSERT(move.start == position);
    position = move.end;
    const bool moves_axes = move.kind == Move::Kind::line || move.kind == Move::Kind::arc;
    for (const double x : move.end) RC_ASSERT(!moves_axes || std::fabs(x) <= 3600.001);
  }
  RC_ASSERT(moves + diagnostics > 0);
}

RC_GTEST_PROP(RandomBytes, EndInADiagnosticOrAMove, (const std::string& text)) {
  read_anything(text);
}

RC_GTEST_PROP(RandomWords, EndInADiagnosticOrAMove, ()) {
  const std::vector<std::string> pieces = {"G", "0",  "1",   "2",  "3",   "81", "83", "92", "28", "10",  "L2", "P",
                                           "X", "Y",  "Z",   "A",  "-",   ".",  "[",  "]",  "#",  "<a>", "=",  "+",
                                           "/", "**", "MOD", "\n", "\n",  "\n", "M",  "T",  "F9", "R",   "I",  "J",
                                           "K", "Q",  "(",   ")",  "SIN", "%",  "N",  "S",  ";",  "9",   "G2", " "};
  std::string text;
  for (const auto& piece : *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(pieces))) text += piece;
  read_anything(text);
}

RC_GTEST_PROP(Lines, ReadBackAsTheyWerePrinted, ()) {
  std::string text = "G1 F60\n";
  std::vector<base::AxisVector> points;
  const int count = *rc::gen::inRange(1, 20);
  for (int i = 0; i < count; ++i) {
    base::AxisVector point;
    for (const base::Axis axis : base::all_axes) {
      point[base::index(axis)] = coordinate();
      text += *rc::gen::element(" ", "", "  ") + std::string(1, base::letter(axis)) + decimal(point[base::index(axis)]);
    }
    text += "\n";
    if (point != (points.empty() ? base::AxisVector{} : points.back())) points.push_back(point);
  }
  const Reading reading = read(text + "M2\n");
  RC_ASSERT(reading.diagnostics.empty());
  RC_ASSERT(reading.lines().size() == points.size());
  for (std::size_t i = 0; i < points.size(); ++i) RC_ASSERT(reading.lines()[i].end == points[i]);
}

RC_GTEST_PROP(Arcs, ReadBackAsTheyWerePrinted, ()) {
  const double x = coordinate() / 4, y = coordinate() / 4, i = coordinate() / 8, j = coordinate() / 8, z = coordinate();
  RC_PRE(std::hypot(i, j) > 1e-3);
  const bool ccw = *rc::gen::arbitrary<bool>();
  // Half a turn about x+i, y+j.
  const std::string text = "F60 G0 X" + decimal(x) + " Y" + decimal(y) + "\n" + (ccw ? "G3" : "G2") + " X" +
                           decimal(x + 2 * i) + " Y" + decimal(y + 2 * j) + " Z" + decimal(z) + " I" + decimal(i) +
                           " J" + decimal(j) + "\nM2\n";
  const Reading reading = read(text);
  RC_ASSERT(reading.diagnostics.empty());
  RC_ASSERT(reading.arcs().size() == 1u);
  const Move arc = reading.arcs()[0];
  RC_ASSERT(xyz(arc.end) == (Point{x + 2 * i, y + 2 * j, z}));
  RC_ASSERT(std::fabs(arc.center_first - (x + i)) < 1e-12);
  RC_ASSERT(std::fabs(arc.center_second - (y + j)) < 1e-12);
  RC_ASSERT(arc.turns == (ccw ? 1 : -1));
}

}  // namespace
}  // namespace leadscrew::gcode
