
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "curve_promises.hpp"
#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_random_text {

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
    const bool moves_axes =
        move.kind == Move::Kind::line || move.kind == Move::Kind::arc || move.kind == Move::Kind::nurbs;
    for (const double x : move.end) RC_ASSERT(!moves_axes || std::fabs(x) <= 3600.001);
    RC_ASSERT(keeps_promises_of_curve(move));
    if (move.kind == Move::Kind::nurbs) RC_ASSERT(curve_is_inside(move, machine, 50));
  }
  RC_ASSERT(moves + diagnostics > 0);
}

RC_GTEST_PROP(RandomBytes, EndInADiagnosticOrAMove, (const std::string& text)) {
  read_anything(text);
}

RC_GTEST_PROP(RandomWords, EndInADiagnosticOrAMove, ()) {
  const std::vector<std::string> pieces = {
      "G",    "0",   "1",  "2",  "3",        "81",      "83",    "92",      "28",  "10", "L2",   "P",    "X",
      "Y",    "Z",   "A",  "-",  ".",        "[",       "]",     "#",       "<a>", "=",  "+",    "/",    "**",
      "MOD",  "\n",  "\n", "\n", "M",        "T",       "F9",    "R",       "I",   "J",  "K",    "Q",    "(",
      ")",    "SIN", "%",  "N",  "S",        ";",       "9",     "G2",      " ",   "G5", "G5.1", "G5.2", "G5.3",
      "G6.2", "L",   "@",  "^",  "(debug,#", "(LOG,%d", "#<_x>", "EXISTS[", "**",  "LT", "(("};
  std::string text;
  for (const auto& piece : *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(pieces))) text += piece;
  read_anything(text);
}

// Lines that nearly make curves, and often do.
RC_GTEST_PROP(RandomCurves, EndInADiagnosticOrAMove, ()) {
  const std::vector<std::string> lines = {"G5.2 P2 L4",
                                          "G5.2 X1 Y2",
                                          "X3 Y4 P2",
                                          "X-5 Y9 Z3 A20",
                                          "G5.3",
                                          "G5.3",
                                          "G6.2 P2 K0",
                                          "G6.2 P3 K0 X0",
                                          "G6.2 P4 K0 X490",
                                          "K0 X5",
                                          "K0 Y499 R2",
                                          "K0.5 X-3",
                                          "K0.5 Z2 R0.001",
                                          "K1",
                                          "K1",
                                          "K1",
                                          "K1",
                                          "K2",
                                          "K0 B400",
                                          "G5 I1 J1 P1 Q1",
                                          "P-9 Q300 X20",
                                          "G5.1 X9 J700 Z1",
                                          "G91",
                                          "G90",
                                          "G20",
                                          "G21",
                                          "G1 X0 Y0 Z0",
                                          "G0 X490 Y-490 Z-3",
                                          "M8",
                                          "F600",
                                          "G93",
                                          "G94",
                                          "G55",
                                          "G10 L2 P1 R30 X5",
                                          "G10 L2 P2 Z9",
                                          "G92 X1",
                                          "X",
                                          "K0 X5 Q1",
                                          "G4 P1",
                                          "G80",
                                          "?",
                                          "I1 J1 P0 Q9 X1 F2"};
  std::string text = "F600\n";
  for (const auto& line : *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(lines))) text += line + "\n";
  read_anything(text);
}

// A curve of G6.2 in all axes, with every knot vector that is clamped, is the one that was printed.
RC_GTEST_PROP(Curves, ReadBackAsTheyWerePrinted, ()) {
  const int order = *rc::gen::inRange(2, highest_degree + 2), n = order + *rc::gen::inRange(0, 20);
  NurbsCurve curve;
  curve.degree = order - 1;
  double knot = coordinate();
  for (int i = 0; i < n + order; ++i) {
    const auto run = std::count(curve.knots.begin(), curve.knots.end(), knot);
    const bool at_end = i < order || i > n;
    if (i == n || (!at_end && (run >= order - 1 || i == order || *rc::gen::arbitrary<bool>()))) {
      knot += *rc::gen::inRange(1, 100'000) / 1e4;
    }
    curve.knots.push_back(knot);
  }
  std::string text = "F60\n";
  for (int i = 0; i < n; ++i) {
    ControlPoint point;
    for (double& x : point.position) x = coordinate();
    point.weight = *rc::gen::inRange(1, 1'000'000) / 1e5;
    std::string words;
    for (const base::Axis axis : base::all_axes) {
      words += std::string(1, base::letter(axis)) + decimal(point.position[base::index(axis)]);
    }
    if (i == 0) text += "G0 " + words + "\nG6.2 P" + std::to_string(order);
    text +=
        " " + words + " R" + decimal(point.weight) + " K" + decimal(curve.knots[static_cast<std::size_t>(i)]) + "\n";
    curve.points.push_back(point);
  }
  for (int i = n; i < n + order; ++i) text += "K" + decimal(curve.knots[static_cast<std::size_t>(i)]) + "\n";
  RC_PRE(curve.points.front().position != curve.points.back().position);
  const Reading reading = read(text + "M2\n");
  RC_ASSERT(reading.problems().empty());
  RC_ASSERT(reading.of(Move::Kind::nurbs).size() == 1u);
  RC_ASSERT(reading.of(Move::Kind::nurbs)[0].curve == curve);
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

}  // namespace test_random_text
}  // namespace leadscrew::gcode
