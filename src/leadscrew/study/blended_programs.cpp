#include <array>
#include <cmath>
#include <complex>
#include <initializer_list>
#include <leadscrew/study/blended_programs.hpp>
#include <numbers>
#include <utility>

namespace leadscrew::study {

namespace {

constexpr LimitSet limits = {200, 1000, 20000};
constexpr machine::AxisLimits a_axis = {
    .travel_min = -360, .travel_max = 360, .velocity = 200, .acceleration = 2000, .jerk = 40000, .blu = 0.001};

using Words = std::initializer_list<std::pair<char, double>>;

std::string block(std::string_view code, Words words) {
  std::string text(code);
  for (const auto& [letter, value] : words) text += word(letter, value);
  return text + '\n';
}

/// To three decimals, as post-processors write.
double rounded(double value) {
  return std::round(value * 1000) / 1000;
}

ProgrammedContour square() {
  return {"G1 X10\nY10\nX0\nY0\n"};
}

ProgrammedContour star() {
  const auto tip = [](int k) { return std::polar(10.0, (0.5 + 0.8 * k) * std::numbers::pi); };
  ProgrammedContour star{{}, {tip(0).real(), tip(0).imag()}};
  for (int k = 1; k <= 5; ++k) star.blocks += block("G1", {{'X', tip(k).real()}, {'Y', tip(k).imag()}});
  return star;
}

double cubic_x(double u) {
  return 20 * u;
}
double cubic_y(double u) {
  return ((-50 * u + 80) * u - 10) * u;
}

template <int lines>
ProgrammedContour cubic() {
  ProgrammedContour cubic;
  for (int k = 1; k <= lines; ++k) {
    const double u = static_cast<double>(k) / lines;
    cubic.blocks += block("G1", {{'X', cubic_x(u)}, {'Y', cubic_y(u)}});
  }
  return cubic;
}

ProgrammedContour rounded_cubic() {
  ProgrammedContour cubic;
  for (int k = 1; k <= 1000; ++k) {
    const double u = k / 1000.0;
    cubic.blocks += block("G1", {{'X', rounded(cubic_x(u))}, {'Y', rounded(cubic_y(u))}});
  }
  return cubic;
}

ProgrammedContour turning_cubic() {
  ProgrammedContour cubic;
  for (int k = 1; k <= 1000; ++k) {
    const double u = k / 1000.0;
    cubic.blocks += block("G1", {{'X', rounded(cubic_x(u))}, {'Y', rounded(cubic_y(u))}, {'A', rounded(3 * u)}});
  }
  return cubic;
}

ProgrammedContour collinear() {
  ProgrammedContour line;
  for (int k = 1; k <= 5000; ++k) line.blocks += block("G1", {{'X', k / 100.0}});
  return line;
}

/// Outwards, turning left; line k is (⌊k/2⌋ + 1)·step long less the radius 1 of the arc at each of its ends:
///
///     ┌─────────┐     the lines on a grid of step,
///     │ ┌───┐   │     sixteen of them, each corner an arc
///     │ │ ──┘   │
///     │ └───────┘
ProgrammedContour pocket() {
  constexpr int lines = 16;
  // Σ (⌊k/2⌋ + 1) = 72, and each arc is π/2 long in place of two radii.
  constexpr double step = (376 + (lines - 1) * (2 - std::numbers::pi / 2)) / 72;
  constexpr std::array<std::array<double, 2>, 4> headings = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  ProgrammedContour pocket;
  double x = 0, y = 0;
  for (int k = 0; k < lines; ++k) {
    const bool is_first = k == 0, is_last = k == lines - 1;
    const int steps = k / 2 + 1;
    const double length = steps * step - (is_first || is_last ? 1 : 2);
    const auto [dx, dy] = headings[static_cast<std::size_t>(k % 4)];
    x += length * dx;
    y += length * dy;
    pocket.blocks += block("G1", {{'X', x}, {'Y', y}});
    if (is_last) break;
    x += dx - dy;
    y += dy + dx;
    pocket.blocks += block("G3", {{'X', x}, {'Y', y}, {'I', -dy}, {'J', dx}});
  }
  return pocket;
}

ProgrammedContour circle() {
  ProgrammedContour circle{{}, {10}};
  for (int k = 1; k <= 2000; ++k) {
    const double angle = k * std::numbers::pi / 1000;
    circle.blocks += block("G1", {{'X', 10 * std::cos(angle)}, {'Y', 10 * std::sin(angle)}});
  }
  return circle;
}

/// 17 rows of 52 lines to and fro over a wavy surface, 16 steps from row to row: 900 lines, 32 corners.
ProgrammedContour finishing() {
  constexpr int rows = 17, lines = 52;
  constexpr double chord = 0.9, step = 2;
  ProgrammedContour finishing;
  for (int row = 0; row < rows; ++row) {
    for (int k = row == 0 ? 1 : 0; k <= lines; ++k) {
      const double x = chord * (row % 2 == 0 ? k : lines - k), y = step * row;
      const double z = 3 * std::sin(x / 9) * std::cos(y / 7);
      finishing.blocks += block("G1", {{'X', rounded(x)}, {'Y', rounded(y)}, {'Z', rounded(z)}});
    }
  }
  return finishing;
}

PartProgram program_of(const BlendedProgram& program, const std::string& path_control) {
  const ProgrammedContour contour = program.contour();
  return {"G21 G90 G17 G94 " + path_control + word('F', program.feed * 60) + "\n" + contour.blocks + "M2\n",
          contour.start};
}

constexpr BlendedProgram cubic_of_92_lines = {
    "plane cubic as 92 lines", cubic<92>, 100, 0.01, 0.474, "LinuxCNC 2.9, without a limit of jerk: 0.487 s"};

constexpr std::array<BlendedProgram, 11> all = {{
    {"square of 10 mm", square, 100, 0.01, 0.958, "LinuxCNC 2.9, without a limit of jerk: 0.878 s"},
    {"five-pointed star, R 10 mm", star, 100, 0.01, {}},
    cubic_of_92_lines,
    {"plane cubic as 1000 lines", cubic<1000>, 100, 0.01, 0.474, "LinuxCNC 2.9, without a limit of jerk: 0.486 s"},
    {"plane cubic as 1000 lines rounded to 1 µm", rounded_cubic, 100, 0.005, 0.474},
    {"plane cubic as 1000 lines rounded to 1 µm, A turning 3°", turning_cubic, 100, 0.01, 0.475,
     "LinuxCNC 2.9, without a limit of jerk: 7.265 s", a_axis},
    {"5000 collinear lines of 10 µm", collinear, 100, 0.01, 0.652, "optimum of one line: 0.650 s", {}, 1e-6},
    {"pocket, 16 lines and 15 quarter arcs R 1 mm", pocket, 80, 0.02, 6.0},
    {"circle R 10 mm as 2000 lines", circle, 100, 0.01, 0.788, "LinuxCNC 2.9, without a limit of jerk: 0.847 s"},
    {"finishing, 900 lines and 32 corners", finishing, 100, 0.01, {}},
    {"finishing, 900 lines and 32 corners", finishing, 100, 0.02, {}},
}};

}  // namespace

std::span<const BlendedProgram> blended_programs() {
  return all;
}

BlendedProgram cubic_as_lines(double feed) {
  BlendedProgram program = cubic_of_92_lines;
  program.feed = feed;
  return program;
}

PartProgram blended(const BlendedProgram& program) {
  return program_of(program, "G64" + word('P', program.tolerance));
}

PartProgram stopping(const BlendedProgram& program) {
  return program_of(program, "G61.1");
}

machine::Machine machine_of(const BlendedProgram& program, base::Period period) {
  machine::Machine machine = machine_with(limits, period);
  machine.axes[base::index(base::Axis::A)] = program.a;
  return machine;
}

std::string circumstances(const BlendedProgram& program) {
  return std::string(program.name) + ", P " + decimal(program.tolerance, 3) + " mm, F " + decimal(program.feed, 0) +
         " mm/s, a " + decimal(limits.acceleration, 0) + " mm/s², j " + decimal(limits.jerk, 0) + " mm/s³";
}

}  // namespace leadscrew::study
