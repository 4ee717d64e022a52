// Feed where a tool touches a surface: the tip's curve with a contact beside it, judged by the referee and by the contact's own
// speed from word to word.

#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/interpolator/interpolator.hpp>
#include <leadscrew/planner/planner.hpp>
#include <leadscrew/referee/referee.hpp>
#include <leadscrew/toolpath/builder.hpp>
#include <numbers>
#include <vector>

namespace leadscrew {
namespace {

/// The tip goes round an ellipse-like quintic, the contact on a curve inside it that is a third as long at one end and nearly as
/// long at the other.
gcode::Move move_over_a_surface() {
  gcode::Move move;
  move.kind = gcode::Move::Kind::nurbs;
  move.path_mode = gcode::PathMode::exact_path;
  move.feed = {gcode::Feed::Mode::units_per_second, 30};
  gcode::NurbsCurve& curve = move.curve;
  curve.degree = 5;
  const std::size_t points = 9;
  curve.knots.assign(6, 0.0);
  for (const double inner : {0.25, 0.5, 0.75}) curve.knots.push_back(inner);
  curve.knots.insert(curve.knots.end(), 6, 1.0);
  for (std::size_t k = 0; k < points; ++k) {
    const double angle = std::numbers::pi * static_cast<double>(k) / (points - 1),
                 inside = 20 + 2.0 * static_cast<double>(k);
    curve.points.push_back({{50 * std::cos(angle), 40 * std::sin(angle), static_cast<double>(k)}, 1});
    curve.contact.push_back({inside * std::cos(angle), inside * std::sin(angle), 0});
  }
  move.start = curve.points.front().position;
  move.end = curve.points.back().position;
  return move;
}

/// Of a non-rational curve with clamped knots, by de Boor's algorithm.
std::array<double, 3> contact_at(const gcode::NurbsCurve& curve, double u) {
  const auto p = static_cast<std::size_t>(curve.degree);
  std::size_t span = p;
  while (span + 1 < curve.contact.size() && curve.knots[span + 1] <= u) ++span;
  std::vector<std::array<double, 3>> d(curve.contact.begin() + static_cast<std::ptrdiff_t>(span - p),
                                       curve.contact.begin() + static_cast<std::ptrdiff_t>(span) + 1);
  for (std::size_t r = 1; r <= p; ++r) {
    for (std::size_t k = p; k >= r; --k) {
      const std::size_t i = span - p + k;
      const double share = (u - curve.knots[i]) / (curve.knots[i + p - r + 1] - curve.knots[i]);
      for (std::size_t c = 0; c < 3; ++c) d[k][c] = (1 - share) * d[k - 1][c] + share * d[k][c];
    }
  }
  return d[p];
}

TEST(ContactFeed, IsKeptWhereNoLimitBinds) {
  const gcode::Move move = move_over_a_surface();
  machine::Machine machine = machine::mill3();
  const double period = machine.period.seconds();
  toolpath::Builder builder(machine);
  builder.push(move);
  builder.finish();
  planner::Planner planner(machine, move.start);
  while (std::optional<toolpath::Element> element = builder.pop()) planner.push(std::move(*element));
  planner.finish();
  bool is_sent = false;
  referee::Referee referee(
      [&](gcode::Move& next) {
        if (is_sent) return false;
        next = move;
        return is_sent = true;
      },
      machine, machine.period);
  interpolator::Interpolator interpolator(machine.period, move.start);
  const geometry::Nurbs piece = std::get<geometry::Nurbs>(toolpath::pieces_of(move).front().curve);
  std::optional<std::array<double, 3>> last;
  std::size_t at_feed = 0, words = 0;
  double fastest_tip = 0, slowest_tip = 1e9;
  std::optional<planner::Chunk> loaded;  // lives until the next is loaded
  while (std::optional<planner::Chunk> chunk = planner.pop()) {
    loaded = std::move(chunk);
    interpolator.load(*loaded);
    while (!interpolator.wants_chunk()) {
      const base::Word word = interpolator.next();
      ++words;
      referee.observe(word.position, word.feed);
      const auto here = contact_at(move.curve, piece.parameter(word.path_length));
      if (last) {
        const double speed = std::hypot(here[0] - (*last)[0], here[1] - (*last)[1], here[2] - (*last)[2]) / period;
        EXPECT_LE(speed, 30 * 1.0005);
        if (word.feed > 30 * 0.9999) {
          ++at_feed;
          EXPECT_NEAR(speed, 30, 0.03);
          fastest_tip = std::max(fastest_tip, word.speed);
          slowest_tip = std::min(slowest_tip, word.speed);
        }
      }
      last = here;
    }
  }
  referee.observe(interpolator.next().position);  // at rest: the end lies between two words
  EXPECT_GT(at_feed, words / 2);
  EXPECT_GT(fastest_tip, 1.3 * slowest_tip);
  const referee::Verdict verdict = referee.conclude();
  EXPECT_TRUE(verdict.violations.empty());
  EXPECT_LE(verdict.feed_max_ratio, 1.001);
  EXPECT_GT(verdict.feed_max_ratio, 0.999);
}

}  // namespace
}  // namespace leadscrew
