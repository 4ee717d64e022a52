#include <algorithm>
#include <cmath>
#include <leadscrew/referee/derivative_check.hpp>
#include <limits>
#include <string>

namespace leadscrew::referee {

namespace {

constexpr const char* names[] = {" velocity", " acceleration", " jerk"};

}  // namespace

double rounding_of(double largest) {
  if (!(largest < std::numeric_limits<double>::max())) return std::numeric_limits<double>::infinity();
  return 8 * (std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest);
}

DerivativeCheck::DerivativeCheck(const machine::Machine& machine, base::Period period) : period_(period.seconds()) {
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    Track& track = tracks_[track_count_++];
    track.axis = axis;
    const machine::AxisLimits& limits = machine.limits(axis);
    const double values[] = {limits.velocity, limits.acceleration, limits.jerk};
    double power = 1;
    for (std::size_t order = 0; order < orders; ++order) {
      power *= period_;
      Limit& limit = track.limits[order];
      limit.value = values[order];
      limit.power = power;
      limit.objectionable = objectionable_ratio * values[order] * power;
      limit.bound = limit.objectionable;
    }
  }
}

void DerivativeCheck::observe(const base::AxisVector& position, base::Line line) {
  for (std::size_t i = 0; i < track_count_; ++i) {
    Track& track = tracks_[i];
    const double value = position[base::index(track.axis)];
    if (words_ == 0) track.last = value;
    difference(track, value, line);
  }
  ++words_;
}

void DerivativeCheck::difference(Track& track, double position, base::Line line) {
  widen(track, std::abs(position));
  const double first = position - track.last;
  const double second = first - track.first_difference;
  const double third = second - track.second_difference;
  track.last = position;
  track.first_difference = first;
  track.second_difference = second;
  const double differences[] = {std::abs(first), std::abs(second), std::abs(third)};
  for (std::size_t order = 0; order < orders; ++order) {
    Limit& limit = track.limits[order];
    limit.greatest = std::max(limit.greatest, differences[order]);
    if (differences[order] > limit.bound) suspect(track, order, differences[order], line);
  }
}

void DerivativeCheck::widen(Track& track, double magnitude) {
  if (magnitude <= track.largest && words_ > 0) return;
  track.largest = std::max(track.largest, magnitude);
  track.rounding = rounding_of(track.largest);
  for (Limit& limit : track.limits) limit.bound = limit.objectionable + track.rounding;
}

std::size_t DerivativeCheck::level_of(double excess) {
  return static_cast<std::size_t>(std::clamp(std::ilogb(excess) - finest_level, 0, levels - 1));
}

void DerivativeCheck::suspect(Track& track, std::size_t order, double difference, base::Line line) {
  Limit& limit = track.limits[order];
  ++limit.violations[level_of(difference - limit.objectionable)];
  if (suspects_.size() == most_violations_listed) return;
  // A k-th difference tells of the middle of its k periods.
  const double periods = static_cast<double>(words_) - static_cast<double>(order + 1) / 2;
  suspects_.push_back(
      {static_cast<std::size_t>(&track - tracks_.data()), order, std::max(0.0, periods * period_), line, difference});
}

/// Differences that exceed what is objectionable by more than the rounding bound, which is a power of two.
std::int64_t DerivativeCheck::count(const Limit& limit, double rounding) {
  std::int64_t sum = 0;
  for (std::size_t level = level_of(rounding); level < levels; ++level) sum += limit.violations[level];
  return sum;
}

void DerivativeCheck::conclude(base::Line line, Verdict& verdict, ViolationLog& log) {
  for (std::size_t k = 0; k < orders; ++k, ++words_) {
    for (std::size_t i = 0; i < track_count_; ++i) difference(tracks_[i], tracks_[i].last, line);
  }
  for (std::size_t i = 0; i < track_count_; ++i) {
    Track& track = tracks_[i];
    AxisVerdict axis{track.axis, 0, 0, 0};
    double* const ratios[] = {&axis.velocity_ratio, &axis.acceleration_ratio, &axis.jerk_ratio};
    for (std::size_t order = 0; order < orders; ++order) {
      const Limit& limit = track.limits[order];
      *ratios[order] = std::max(0.0, limit.greatest - track.rounding) / limit.power / limit.value;
      log.add_count(count(limit, track.rounding));
    }
    verdict.axes.push_back(axis);
  }
  for (const Suspect& suspect : suspects_) {
    const Track& track = tracks_[suspect.track];
    const Limit& limit = track.limits[suspect.order];
    if (level_of(suspect.difference - limit.objectionable) < level_of(track.rounding)) continue;
    log.list({suspect.t, suspect.line, std::string(1, base::letter(track.axis)) + names[suspect.order],
              (suspect.difference - track.rounding) / limit.power, limit.value});
  }
}

}  // namespace leadscrew::referee
