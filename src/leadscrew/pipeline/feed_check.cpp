#include <algorithm>
#include <cmath>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/pipeline/feed_check.hpp>
#include <leadscrew/pipeline/programmed_feed.hpp>
#include <leadscrew/toolpath/feed_length.hpp>
#include <leadscrew/toolpath/path.hpp>
#include <limits>

namespace leadscrew::pipeline {

namespace {

constexpr std::size_t most_lines_told = 50;  // the reader tells 100 warnings in all
constexpr double least_excess = 1.001;       // of the possible feed

/// At so many even parts of a piece its direction is looked at: one of a line; of a curve, every 0.05 rad of an arc.
int parts_of_direction(const toolpath::AxisPath& axes) {
  if (axes.line()) return 1;
  const geometry::Arc* arc = axes.arc();
  return arc ? static_cast<int>(std::clamp(std::abs(arc->angle_rate()) * arc->length() / 0.05, 8.0, 256.0)) : 64;
}

}  // namespace

base::Diagnostic warning_of(const FeedExcess& excess) {
  const std::string unit = excess.is_rotary ? " degrees/min" : " mm/min";
  return {base::Severity::warning,
          "feed-beyond-axis",
          "a feed of " + base::text(excess.asked * 60, 6) + unit + " is more than the velocity of axis " +
              base::letter(excess.axis) + " allows here",
          "no more than " + base::text(excess.possible * 60, 6) + unit + " can be kept throughout this block",
          {},
          {}};
}

std::optional<FeedExcess> FeedCheck::observe(const gcode::Move& move) {
  if (lines_.size() == most_lines_told) return std::nullopt;
  auto excess = excess_of(move);
  if (!excess || !lines_.insert(base::place_of(move.line)).second) return std::nullopt;
  return excess;
}

std::optional<FeedExcess> FeedCheck::excess_of(const gcode::Move& move) const {
  const double asked = programmed_feed(move);
  // Of the tip it differs from place to place, as do the directions of the axes.
  if (asked == 0 || move.is_of_tip) return std::nullopt;
  FeedExcess worst{.asked = asked, .possible = std::numeric_limits<double>::infinity()};
  for (const toolpath::Piece& piece : toolpath::pieces_of(move)) {
    const toolpath::AxisPath axes = piece.axes();
    const int parts = parts_of_direction(axes);
    for (int k = 0; k <= parts; ++k) {
      const double s = axes.length() * k / parts;
      lower(axes.jets(s), piece.feed_rate(s), worst);
    }
    worst.is_rotary = piece.feed_axes == toolpath::FeedAxes::abc;
  }
  return asked > least_excess * worst.possible ? std::optional(worst) : std::nullopt;
}

/// To what the velocities of axes allow where feed is `rate` times the speed along the path.
void FeedCheck::lower(const geometry::PointJet& jet, double rate, FeedExcess& excess) const {
  for (const base::Axis axis : base::all_axes) {
    const double of_axis = std::abs(jet[base::index(axis)].first);
    const double possible = of_axis > 0 ? constraints_.of_axis(axis).velocity / of_axis * rate : excess.possible;
    if (!(possible < excess.possible)) continue;
    excess.axis = axis;
    excess.possible = possible;
  }
}

}  // namespace leadscrew::pipeline
