#include <algorithm>
#include <cmath>
#include <leadscrew/nc/block_look_ahead.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <utility>

namespace leadscrew::nc {

namespace {

constexpr double step_of_rest = 0.4;        // of √a
constexpr double share_of_junctions = 0.1;  // of what an axis' acceleration changes in the shorter block

/// Steps of its path.
double length(const PlannedBlock& planned) {
  return static_cast<double>(planned.block.commands) *
         std::min(numeric::norm(planned.entry), numeric::norm(planned.exit));
}

/// Speed v at which an axis' step of velocity, v·change, is no more than a share of what its acceleration changes in a
/// block of this length: share·a l/u, where the block's speed u rises from v to √(v² + b l) at most and is never beyond
/// the greatest.
double speed_by_step(double change, double share_of_a, double path_acceleration, double length, double greatest) {
  const double rising = path_acceleration * length, step = share_of_a * length / change;
  const double square = rising / 2 * (std::sqrt(1 + 4 * (step / rising) * (step / rising)) - 1);
  return std::max(std::sqrt(square), step / greatest);
}

/// Commands/s at its start from which a block can come down to this at its end, `greatest` at most.
double greatest_entry(const PlannedBlock& planned, double exit_rate, double greatest) {
  const auto commands =
      static_cast<double>(std::max<std::int64_t>(0, planned.block.commands - 2 * planned.block.uncertain));
  return std::min(greatest, std::sqrt(exit_rate * exit_rate + 2 * planned.acceleration * commands));
}

}  // namespace

double BlockLookAhead::greatest_rate(const PlannedBlock& planned) const {
  return std::min(planned.greatest_rate, planned.rate * feed_factor_);
}

double BlockLookAhead::rest_rate(const PlannedBlock& planned) const {
  return std::min(greatest_rate(planned), step_of_rest * std::sqrt(planned.acceleration));
}

/// Speed at which both can meet; 0 where the path must rest.
double BlockLookAhead::junction(const PlannedBlock& before, const PlannedBlock& after) const {
  if (before.stops || after.from_rest || before.block.kind == Block::Kind::dwell ||
      after.block.kind == Block::Kind::dwell)
    return 0;
  const double out = numeric::norm(before.exit), in = numeric::norm(after.entry);
  double speed = std::min(greatest_rate(before) * out, greatest_rate(after) * in);
  // Chords of one curve turn as it does, but for what the lattice does not show.
  if (after.goes_on) return speed;
  const double shorter = std::min(length(before), length(after));
  const double fastest = std::max(before.greatest_rate * out, after.greatest_rate * in);
  const double path_acceleration = std::max(before.acceleration * out, after.acceleration * in);
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    const double change = std::abs(before.exit_course[i] - after.entry_course[i]);
    if (change < 1e-12) continue;
    const double acceleration = machine_.limits(axis).acceleration / machine_.limits(axis).blu;
    speed = std::min({speed, step_of_rest * std::sqrt(acceleration) / change,
                      speed_by_step(change, share_of_junctions * acceleration, path_acceleration, shorter, fastest)});
  }
  const bool is_rest = speed < rest_rate(before) * out || speed < rest_rate(after) * in;
  return is_rest ? 0 : speed;
}

BlockLookAhead::Next BlockLookAhead::pop(double feed_factor) {
  feed_factor_ = feed_factor;
  double exit_speed = 0;
  for (std::size_t i = blocks_.size() - 1; i > 0; --i) {
    const PlannedBlock& after = blocks_[i];
    if (after.block.kind == Block::Kind::dwell) {
      exit_speed = 0;
      continue;
    }
    const double exit_rate = std::max(exit_speed / numeric::norm(after.exit), rest_rate(after));
    exit_speed = std::min(junction(blocks_[i - 1], after),
                          greatest_entry(after, exit_rate, greatest_rate(after)) * numeric::norm(after.entry));
  }
  Next next{std::move(blocks_.front())};
  blocks_.pop_front();
  if (next.planned.block.kind != Block::Kind::dwell) {
    next.rest_rate = rest_rate(next.planned);
    next.entry_rate = std::max(entry_speed_ / numeric::norm(next.planned.entry), next.rest_rate);
    next.exit_rate = std::max(exit_speed / numeric::norm(next.planned.exit), next.rest_rate);
  }
  entry_speed_ = next.planned.block.kind == Block::Kind::dwell ? 0 : exit_speed;
  return next;
}

}  // namespace leadscrew::nc
