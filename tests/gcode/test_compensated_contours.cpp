// Cutter compensation along random contours: where the tool's middle is, by samples of distances that share no code with
// what makes it; and that what is refused is a gouge.

#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_compensated_contours {

struct Place {
  double x = 0, y = 0;
};

double between(Place a, Place b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

Place start_of(const Move& move) {
  return {move.start[0], move.start[1]};
}
Place end_of(const Move& move) {
  return {move.end[0], move.end[1]};
}
Place center_of(const Move& move) {
  return {move.center_first, move.center_second};
}

// Radians in the direction of the arc; a whole turn where the ends coincide.
double swept(const Move& arc) {
  const Place a = start_of(arc), b = end_of(arc), c = center_of(arc);
  double angle = std::atan2(b.y - c.y, b.x - c.x) - std::atan2(a.y - c.y, a.x - c.x);
  const double way = arc.turns > 0 ? 1 : -1;
  while (way * angle <= 0) angle += way * 2 * M_PI;
  while (way * angle > 2 * M_PI) angle -= way * 2 * M_PI;
  if (a.x == b.x && a.y == b.y) angle = way * 2 * M_PI;
  return angle;
}

Place at(const Move& move, double part) {
  const Place a = start_of(move), b = end_of(move), c = center_of(move);
  if (move.kind != Move::Kind::arc) return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
  const double angle = std::atan2(a.y - c.y, a.x - c.x) + part * swept(move), radius = between(a, c);
  return {c.x + radius * std::cos(angle), c.y + radius * std::sin(angle)};
}

double to_contour(Place p, const Move& piece) {
  const Place a = start_of(piece), b = end_of(piece), c = center_of(piece);
  const double to_ends = std::min(between(p, a), between(p, b));
  if (piece.kind != Move::Kind::arc) {
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double part = ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy);
    return part <= 0 || part >= 1 ? to_ends : between(p, {a.x + part * dx, a.y + part * dy});
  }
  const double all = std::fabs(swept(piece)), way = piece.turns > 0 ? 1 : -1;
  double angle = way * (std::atan2(p.y - c.y, p.x - c.x) - std::atan2(a.y - c.y, a.x - c.x));
  while (angle < 0) angle += 2 * M_PI;
  while (angle >= 2 * M_PI) angle -= 2 * M_PI;
  return angle <= all ? std::fabs(between(p, c) - between(a, c)) : to_ends;
}

std::string number(double value) {
  std::ostringstream out;
  out << std::round(value * 1e4) / 1e4;
  return out.str();
}

struct Contour {
  double radius = 0;
  bool is_left = false;
  std::vector<std::string> blocks;  // lines and arcs, from (0, 0) on

  // The first is the way in, the last the way out.
  std::string program(bool is_compensated) const {
    const std::string code = is_left ? "G41.1 D" : "G42.1 D";
    std::string text = "F600\n" + (is_compensated ? code + number(2 * radius) : std::string("G40")) + "\n";
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      if (i + 1 == blocks.size()) text += "G40 ";
      text += blocks[i] + "\n";
    }
    return text + "M2\n";
  }
};

// `pieces` lines and arcs one behind another, none too large for the machine.
Contour random_contour(int pieces) {
  Contour contour;
  contour.radius = *rc::gen::inRange(5, 50) / 10.0;
  contour.is_left = *rc::gen::arbitrary<bool>();
  Place here{30, 0};
  double heads = 0;
  contour.blocks.push_back("G1 X30 Y0");
  for (int i = 0; i < pieces; ++i) {
    if (i > 0 || *rc::gen::arbitrary<bool>()) heads += *rc::gen::inRange(-170, 171) * M_PI / 180;
    const double length = *rc::gen::inRange(5, 300) / 10.0;
    const Place end{std::round(1e3 * (here.x + length * std::cos(heads))) / 1e3,
                    std::round(1e3 * (here.y + length * std::sin(heads))) / 1e3};
    const int kind = *rc::gen::inRange(0, 4);
    std::string block = kind < 2 ? "G1" : kind == 2 ? "G2" : "G3";
    block += " X" + number(end.x) + " Y" + number(end.y);
    if (kind >= 2) {
      const double least = between(here, end) / 2 + 0.01, radius = least * (1 + *rc::gen::inRange(0, 30) / 10.0);
      block += " R" + std::string(*rc::gen::inRange(0, 4) == 0 ? "-" : "") + number(radius);
    }
    contour.blocks.push_back(block);
    here = end;
  }
  contour.blocks.push_back("G1 X" + number(here.x) + " Y" + number(here.y + 70));
  return contour;
}

// As programmed, and as the tool's middle goes.
struct Both {
  Reading programmed;
  Reading compensated;
};

Both read_both(const Contour& contour) {
  Conditions conditions;
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y}) {
    conditions.machine.axes[base::index(axis)]->travel_min = -5000;
    conditions.machine.axes[base::index(axis)]->travel_max = 5000;
  }
  return {read(contour.program(false), conditions), read(contour.program(true), conditions)};
}

// The motions of lines 4 …, the contour's, of one of them.
std::vector<Move> contour_of(const Reading& reading, std::size_t pieces) {
  std::vector<Move> moves;
  for (const Move& move : reading.moves) {
    const std::int64_t line = base::number(move.line);
    const bool is_motion = move.kind == Move::Kind::line || move.kind == Move::Kind::arc;
    if (is_motion && line >= 4 && line < 4 + static_cast<std::int64_t>(pieces)) moves.push_back(move);
  }
  return moves;
}

// Whether a piece passes the start of one before it, or nearly: what is before may lead in, what is behind off.
bool closes(const std::vector<Move>& pieces) {
  for (std::size_t j = 0; j < pieces.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      const Place start = start_of(pieces[i]);
      if ((i + 1 == j ? between(start, end_of(pieces[j])) : to_contour(start, pieces[j])) < 0.02) return true;
    }
  }
  return false;
}

// Along the piece itself the distance is the radius, round a corner that from the corner. From no neighbour is it less, nor
// from any other but the first and the last.
void check_way(const Contour& contour, const Both& both) {
  const std::size_t count = contour.blocks.size() - 2;
  const std::vector<Move> pieces = contour_of(both.programmed, count), way = contour_of(both.compensated, count);
  RC_ASSERT(pieces.size() == count);
  constexpr int steps = 50;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const std::size_t of = static_cast<std::size_t>(base::number(way[i].line)) - 4;
    const bool is_corner = i + 1 < way.size() && way[i + 1].line == way[i].line;
    if (i > 0) RC_ASSERT(way[i].start == way[i - 1].end);
    for (int k = 0; k <= steps; ++k) {
      const Place place = at(way[i], static_cast<double>(k) / steps);
      const double distance = is_corner ? between(place, start_of(pieces[of])) : to_contour(place, pieces[of]);
      RC_ASSERT(std::fabs(distance - contour.radius) <= 1e-6);
      for (std::size_t near = 0; near < count; ++near) {
        const bool is_neighbour = near + 1 >= of && near <= of + 1 && !(near == of + 1 && is_corner);
        if (!is_neighbour && (near == 0 || near + 1 == count)) continue;
        RC_ASSERT(to_contour(place, pieces[near]) >= contour.radius - 1e-6);
      }
    }
  }
}

RC_GTEST_PROP(CompensatedContours, KeepTheRadiusFromTheContour, ()) {
  const Contour contour = random_contour(*rc::gen::inRange(1, 7));
  const Both both = read_both(contour);
  RC_PRE(both.programmed.problems().empty());
  RC_PRE(!closes(contour_of(both.programmed, contour.blocks.size() - 2)));
  RC_CLASSIFY(both.compensated.problems().empty(), "fits");
  for (const base::Diagnostic& problem : both.compensated.diagnostics)
    RC_ASSERT(problem.code == "cutter-gouge" || problem.code == "program-end");
  if (both.compensated.problems().empty()) check_way(contour, both);
}

// The place beside a piece where the tool is while it touches there.
Place beside(const Move& piece, double part, double aside) {
  const Place here = at(piece, part);
  const double small = 1e-7;
  const Place before = at(piece, part - small), behind = at(piece, part + small);
  const double length = between(before, behind);
  return {here.x - aside * (behind.y - before.y) / length, here.y + aside * (behind.x - before.x) / length};
}

// Two pieces: whether the tool can go beside the first to where it can go on beside the second, found by samples. Beside
// the first it goes as far as it is clear of the second, and there it must come to a place beside the second behind which
// all is clear of the first.
bool fits_between(const Move& one, const Move& two, double aside) {
  const double radius = std::fabs(aside), slack = 2e-7;
  constexpr int steps = 20000;
  const auto clear = [&](Place place, const Move& piece, double by) { return to_contour(place, piece) >= radius - by; };
  const auto swallowed = [&](const Move& piece) {
    return piece.kind == Move::Kind::arc && (piece.turns > 0) == (aside > 0) &&
           between(start_of(piece), center_of(piece)) <= radius;
  };
  if (swallowed(one) || swallowed(two)) return false;
  int last = 0;
  while (last <= steps && clear(beside(one, static_cast<double>(last) / steps, aside), two, slack)) ++last;
  const Place from = beside(one, static_cast<double>(std::min(last, steps)) / steps, aside);
  int first = steps;
  while (first >= 0 && clear(beside(two, static_cast<double>(first) / steps, aside), one, slack)) --first;
  if (first < 0 && last > steps) {  // round the corner, or smoothly
    const Place corner = end_of(one), a = beside(one, 1, aside), b = beside(two, 0, aside);
    const double begins = std::atan2(a.y - corner.y, a.x - corner.x);
    const double turn = std::remainder(std::atan2(b.y - corner.y, b.x - corner.x) - begins, 2 * M_PI);
    for (int k = 0; k <= steps; ++k) {
      const double angle = begins + turn * k / steps;
      const Place place{corner.x + radius * std::cos(angle), corner.y + radius * std::sin(angle)};
      if (!clear(place, one, slack) || !clear(place, two, slack)) return false;
    }
    return true;
  }
  const Place to = beside(two, static_cast<double>(std::max(first, 0)) / steps, aside);
  // Only at an inner corner ends one way before the other begins.
  double near_corner = radius;
  for (int k = 1; k <= 100; ++k) near_corner = std::min(near_corner, between(beside(one, 1, aside), at(two, k * 1e-6)));
  if (near_corner > radius - 1e-9) return false;
  constexpr double least = 0.5;  // is left of both
  if (between(from, beside(one, 0, aside)) < least || between(to, beside(two, 1, aside)) < least) return false;
  return between(from, to) < 0.02;
}

// A gouge that is told is one.
RC_GTEST_PROP(CompensatedContours, AreRefusedWhereTheToolDoesNotFitAlone, ()) {
  const Contour contour = random_contour(2);
  const Both both = read_both(contour);
  RC_PRE(both.programmed.problems().empty());
  const std::vector<Move> pieces = contour_of(both.programmed, 2);
  RC_PRE(pieces.size() == 2u);
  const bool is_refused = !both.compensated.problems().empty();
  RC_LOG() << contour.program(true) << both.compensated.problems();
  RC_CLASSIFY(is_refused, "refused");
  const double aside = contour.is_left ? contour.radius : -contour.radius;
  // Where the way in has an inner corner, nothing may be left of the first; and the tool may not fit between them.
  const bool is_whole =
      (at(pieces[0], 1e-6).y - start_of(pieces[0]).y) * aside <= 0 && !both.compensated.problems().starts_with("4:");
  if (is_refused && is_whole) RC_ASSERT(!fits_between(pieces[0], pieces[1], aside));
}

// How near a way comes to a piece: the least of samples, and more of them about it.
double nearest(const Move& way, const Move& piece) {
  double least = 1e9, best = 0, reach = 1;
  for (int finer = 0; finer < 4; ++finer, reach /= 100) {
    const double middle = best;
    for (int k = -400; k <= 400; ++k) {
      const double part = std::clamp(middle + reach * k / 400, 0.0, 1.0);
      const double distance = to_contour(at(way, part), piece);
      if (distance < least) least = distance, best = part;
    }
  }
  return least;
}

// The numbers of the two lines that a gouge names.
std::pair<std::size_t, std::size_t> lines_of(const base::Diagnostic& gouge) {
  const std::string& message = gouge.message;
  const std::size_t first = message.find("line "), second = message.rfind("line ");
  return {std::stoul(message.substr(first + 5)), std::stoul(message.substr(second + 5))};
}

// A gouge that is told beyond neighbours is one: along one of both lines the tool is nearer to the other than its radius.
RC_GTEST_PROP(CompensatedContours, AreRefusedBeyondNeighboursWhereTheToolCuts, ()) {
  const Contour contour = random_contour(*rc::gen::inRange(3, 9));
  const Both both = read_both(contour);
  RC_PRE(both.programmed.problems().empty());
  const std::size_t count = contour.blocks.size() - 2;
  const std::vector<Move> pieces = contour_of(both.programmed, count), ways = contour_of(both.compensated, count);
  RC_PRE(pieces.size() == count);
  bool is_beyond = false;
  for (const base::Diagnostic& problem : both.compensated.diagnostics) {
    if (problem.code != "cutter-gouge" || problem.message.find("between") == std::string::npos) continue;
    const auto [one, two] = lines_of(problem);
    if (one + 1 >= two) continue;
    is_beyond = true;
    double least = 1e9;
    for (const Move& way : ways) {
      const auto line = static_cast<std::size_t>(base::number(way.line));
      if (line == one) least = std::min(least, nearest(way, pieces[two - 4]));
      if (line == two) least = std::min(least, nearest(way, pieces[one - 4]));
    }
    RC_LOG() << contour.program(true) << problem.message << "; " << least;
    RC_ASSERT(least < contour.radius - 2e-7);
  }
  RC_CLASSIFY(is_beyond, "beyond");
}

// What its end and its beginning cut by less than 0.01 mm, where a contour closes at an angle, is a warning; what the end
// misses the beginning by is the rounding of programs.
TEST(CompensatedContours, TellSlightCutsWhereTheyClose) {
  const auto problems = [](const std::string& before, const std::string& last) {
    return read("F600\nG0 X10 Y8\nG41.1 D10\nG1 X10 Y0\nX30 Y0\nY40\nX0\n" + before + "\n" + last +
                "\nG40\nG1 X10 Y8\nM2\n")
        .problems();
  };
  EXPECT_EQ(problems("Y0.6", "X10 Y0"), "9:1 cutter-gouge; ");
  EXPECT_EQ(problems("Y2", "X10 Y0"), "9:1 cutter-gouge; ");
  EXPECT_EQ(problems("Y0", "X10 Y0"), "");
  EXPECT_EQ(problems("Y0.002", "X10 Y0"), "");
  EXPECT_EQ(problems("Y0.001", "X10 Y0.001"), "");
  const Reading slight =
      read("F600\nG0 X10 Y8\nG41.1 D10\nG1 X10 Y0\nX30 Y0\nY40\nX0\nY0.6\nX10 Y0\nG40\nG1 X10 Y8\nM2\n");
  EXPECT_EQ(slight.lines().size(), 8U);  // accepted
}

}  // namespace test_compensated_contours
}  // namespace leadscrew::gcode
