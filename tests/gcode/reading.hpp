#pragma once
// Reads a program from a text and keeps all that came of it.

#include <gtest/gtest.h>

#include <leadscrew/gcode/number.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/machine/machine.hpp>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace leadscrew::gcode {

/// A machine with all nine axes, ±500 mm and ±3600 degrees.
inline machine::Machine nine_axes() {
  machine::Machine machine = machine::mill3();
  machine.name = "nine axes";
  for (const base::Axis axis : base::all_axes) {
    const double travel = base::is_rotary(axis) ? 3600 : 500;
    machine.axes[base::index(axis)] = {-travel, travel, 200, 1000, 20000, 0.001};
  }
  return machine;
}

struct Reading {
  std::vector<Move> moves;  ///< all of them, events too
  std::vector<base::Diagnostic> diagnostics;
  std::int64_t errors = 0;
  std::int64_t blocks = 0;

  std::vector<Move> of(Move::Kind kind) const {
    std::vector<Move> result;
    for (const Move& move : moves) {
      if (move.kind == kind) result.push_back(move);
    }
    return result;
  }
  std::vector<Move> lines() const { return of(Move::Kind::line); }
  std::vector<Move> arcs() const { return of(Move::Kind::arc); }
  std::vector<base::Event> events() const {
    std::vector<base::Event> result;
    for (const Move& move : of(Move::Kind::event)) result.push_back(move.event);
    return result;
  }
  /// "3:7 arc-radius; ": places and codes of all that is worse than a note.
  std::string problems() const {
    std::string result;
    for (const base::Diagnostic& d : diagnostics) {
      if (d.severity == base::Severity::note) continue;
      result += std::to_string(d.place.line) + ":" + std::to_string(d.place.column) + " " + std::string(d.code) + "; ";
    }
    return result;
  }
};

struct Conditions {
  machine::Machine machine = nine_axes();
  machine::ToolTable tools;
  ReaderOptions options;
};

/// What is read is of a dialect.
inline Conditions in_dialect(Dialect dialect) {
  Conditions conditions;
  conditions.options.dialect = dialect;
  return conditions;
}

inline Reading read_source(ByteSource source, const Conditions& conditions) {
  Reading reading;
  Reader reader(std::move(source), conditions.machine, conditions.tools, conditions.options,
                [&](const base::Diagnostic& d) { reading.diagnostics.push_back(d); });
  Move move;
  while (reader.next(move)) reading.moves.push_back(move);
  EXPECT_FALSE(reader.next(move));
  reading.errors = reader.errors();
  reading.blocks = reader.blocks();
  return reading;
}

inline Reading read(std::string_view text, const Conditions& conditions = {}) {
  return read_source(text_source(text), conditions);
}

/// Reads a program that must have no problem.
inline Reading read_well(std::string_view text, const Conditions& conditions = {}) {
  Reading reading = read(text, conditions);
  EXPECT_EQ(reading.problems(), "") << text;
  return reading;
}

inline double at(const base::AxisVector& position, base::Axis axis) {
  return position[base::index(axis)];
}

/// Where X comes to, line by line: "1 2 3 ".
inline std::string ends_along_x(const Reading& reading) {
  std::string result;
  for (const Move& move : reading.lines()) result += text(at(move.end, base::Axis::X)) + " ";
  return result;
}

/// Coordinates along X, Y and Z.
struct Point {
  double x, y, z;
  friend bool operator==(const Point&, const Point&) = default;
};
inline Point xyz(const base::AxisVector& p) {
  return {p[0], p[1], p[2]};
}
inline std::ostream& operator<<(std::ostream& out, const Point& p) {
  return out << "(" << p.x << " " << p.y << " " << p.z << ")";
}

}  // namespace leadscrew::gcode
