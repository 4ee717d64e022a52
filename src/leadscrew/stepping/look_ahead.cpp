#include <algorithm>
#include <cmath>
#include <leadscrew/stepping/look_ahead.hpp>
#include <utility>

namespace leadscrew::stepping {

namespace {

constexpr double step_of_rest = 0.4;        // of √a
constexpr double share_of_junctions = 0.1;  // of an axis' acceleration, over the shorter block

/// The block takes no less.
double least_seconds(const PlannedBlock& planned) {
  return static_cast<double>(planned.block.commands) / planned.greatest_rate;
}

/// Commands/s at its start from which a block can come down to this at its end.
double greatest_entry(const PlannedBlock& planned, double exit_rate) {
  const auto commands =
      static_cast<double>(std::max<std::int64_t>(0, planned.block.commands - 2 * uncertain_commands(planned.block)));
  return std::min(planned.greatest_rate, std::sqrt(exit_rate * exit_rate + 2 * planned.acceleration * commands));
}

}  // namespace

double norm(const std::array<double, base::axis_count>& steps) {
  double square = 0;
  for (const double of_axis : steps) square += of_axis * of_axis;
  return std::sqrt(square);
}

double rest_rate(const PlannedBlock& planned) {
  return std::min(planned.greatest_rate, step_of_rest * std::sqrt(planned.acceleration));
}

/// Speed at which both can meet; 0 where the path must rest.
double LookAhead::junction(const PlannedBlock& before, const PlannedBlock& after) const {
  if (before.stops || before.block.kind == Block::Kind::dwell || after.block.kind == Block::Kind::dwell) return 0;
  const double out = norm(before.exit), in = norm(after.entry);
  double speed = std::min(before.greatest_rate * out, after.greatest_rate * in);
  // Chords of one curve turn as it does, but for what the lattice does not show.
  if (after.goes_on) return speed;
  const double seconds = std::min(least_seconds(before), least_seconds(after));
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    const double change = std::abs(before.exit[i] / out - after.entry[i] / in);
    if (change < 1e-12) continue;
    const double acceleration = machine_.limits(axis).acceleration / machine_.limits(axis).blu;
    const double step = std::min(step_of_rest * std::sqrt(acceleration), share_of_junctions * acceleration * seconds);
    speed = std::min(speed, step / change);
  }
  const bool is_rest = speed < rest_rate(before) * out || speed < rest_rate(after) * in;
  return is_rest ? 0 : speed;
}

LookAhead::Next LookAhead::pop() {
  double exit_speed = 0;
  for (std::size_t i = blocks_.size() - 1; i > 0; --i) {
    const PlannedBlock& after = blocks_[i];
    if (after.block.kind == Block::Kind::dwell) {
      exit_speed = 0;
      continue;
    }
    const double exit_rate = std::max(exit_speed / norm(after.exit), rest_rate(after));
    exit_speed = std::min(junction(blocks_[i - 1], after), greatest_entry(after, exit_rate) * norm(after.entry));
  }
  Next next{std::move(blocks_.front())};
  blocks_.pop_front();
  if (next.planned.block.kind != Block::Kind::dwell) {
    next.entry_rate = std::max(entry_speed_ / norm(next.planned.entry), rest_rate(next.planned));
    next.exit_rate = std::max(exit_speed / norm(next.planned.exit), rest_rate(next.planned));
  }
  entry_speed_ = next.planned.block.kind == Block::Kind::dwell ? 0 : exit_speed;
  return next;
}

}  // namespace leadscrew::stepping
