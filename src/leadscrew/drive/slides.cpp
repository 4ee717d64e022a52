#include <algorithm>
#include <cmath>
#include <leadscrew/drive/slides.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/referee/metric.hpp>
#include <numbers>

namespace leadscrew::drive {

namespace {

constexpr double quiet_time = 0.05, longest_time = 4;  // s after the last word

base::AxisVector scale_of(const machine::Machine& machine) {
  base::AxisVector scale{};
  for (const base::Axis axis : base::all_axes) {
    if (machine.has(axis)) scale[base::index(axis)] = base::is_rotary(axis) ? referee::millimetres_per_degree : 1;
  }
  return scale;
}

}  // namespace

base::Result<Slides> Slides::create(const machine::Machine& machine, LoopKind kind, referee::MoveSource moves) {
  auto follower = servo::Follower::create(machine, kind);
  if (!follower) return base::failure(std::move(follower.error()));
  return Slides(machine, std::move(moves), std::move(*follower));
}

Slides::Slides(const machine::Machine& machine, referee::MoveSource moves, servo::Follower follower)
    : machine_(&machine),
      axes_(machine.axis_set()),
      follower_(std::move(follower)),
      tracking_(axes_, machine.period),
      matcher_(scale_of(machine), servo::window_of(follower_.lag(), machine.period)),
      referee_(std::move(moves), machine, machine.period, files::interrupted),
      poses_(machine),
      quiet_(servo::periods_in(std::max(quiet_time, 2 * std::min(follower_.lag(), 1.0)), machine.period)),
      most_after_(std::min<std::int64_t>(servo::periods_in(longest_time, machine.period), 200'000)) {}

base::Result<std::optional<servo::Followed>> Slides::follow(const base::Word& word) {
  const std::optional<servo::Followed> followed = follower_.follow(word);
  if (!followed) return followed;
  if (auto stable = servo::check_followed(*followed, *machine_); !stable)
    return base::failure(std::move(stable.error()));
  poses_.advance(followed->word.tick);
  tracking_.observe(*followed, tip_motions_.next(poses_, *followed));
  referee_.observe(followed->position);
  observe_contour(*followed);
  if (ending_) watch_rest(*followed);
  return followed;
}

void Slides::watch_rest(const servo::Followed& followed) {
  ++since_end_;
  after_end_.push_back(followed.position);
  if (since_end_ < quiet_) return;
  const base::AxisVector& before = after_end_[static_cast<std::size_t>(since_end_ - quiet_)];
  rests_ = true;
  for (const base::Axis axis : base::all_axes) {
    if (!axes_.contains(axis)) continue;
    const std::size_t k = base::index(axis);
    const double blu = machine_->limits(axis).blu;
    const std::optional<double> counts = machine_->drives[k].encoder_counts;
    // Between two counts of its encoder a slide may hunt for ever.
    const double count = counts ? 1 / *counts : blu;
    const bool hunts = std::all_of(after_end_.end() - quiet_, after_end_.end(), [&](const base::AxisVector& at) {
      return std::fabs(at[k] - followed.position[k]) <= count;
    });
    rests_ = rests_ && hunts && std::fabs(followed.position[k] - before[k]) <= blu / 4;
  }
}

/// Of the tip where rotary axes carry it, so that slides that err together and not at the tip do not count.
void Slides::observe_contour(const servo::Followed& followed) {
  const auto commanded = poses_.of(followed.word.position), actual = poses_.of(followed.position);
  if (commanded && actual) {
    matcher_.observe(commanded->tip, actual->tip);
  } else {
    matcher_.observe(followed.word.position, followed.position);
  }
}

/// Tip and direction apart, of places that were matched by both.
void Slides::note_contour(servo::Contour& contour) {
  const auto there = poses_.direction_at(contour.nearest), here = poses_.direction_at(contour.actual);
  if (!there || !here) return;
  double apart = 0, off = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    apart += ((*here)[i] - (*there)[i]) * ((*here)[i] - (*there)[i]);
    off += (contour.actual[i] - contour.nearest[i]) * (contour.actual[i] - contour.nearest[i]);
  }
  const double angle = 2 * std::asin(std::min(1.0, std::sqrt(apart) / 2)) * (180 / std::numbers::pi);
  contour_.orientation = std::max(contour_.orientation.value_or(0), angle);
  contour.distance = std::sqrt(off);
}

std::vector<servo::Contour> Slides::take_contour() {
  std::vector<servo::Contour> contours = matcher_.take();
  for (servo::Contour& contour : contours) {
    note_contour(contour);
    const double error = contour.distance;
    if (error > contour_.greatest) {
      contour_.greatest = error;
      contour_.at = static_cast<double>(contour_count_ * matcher_.stride()) * machine_->period.seconds();
    }
    contour_squares_ += error * error;
    ++contour_count_;
  }
  return contours;
}

/// How long it takes after the last word until every slide stays within a BLU of where it comes to rest.
std::optional<double> Slides::settling() const {
  if (!rests_) return std::nullopt;
  const base::AxisVector& rest = after_end_.back();
  std::size_t last = 0;
  for (std::size_t i = 0; i < after_end_.size(); ++i) {
    for (const base::Axis axis : base::all_axes) {
      const std::size_t k = base::index(axis);
      if (axes_.contains(axis) && std::fabs(after_end_[i][k] - rest[k]) > machine_->limits(axis).blu) last = i + 1;
    }
  }
  return static_cast<double>(last) * machine_->period.seconds();
}

std::vector<std::pair<base::Axis, PulseCounts>> Slides::pulses() const {
  std::vector<std::pair<base::Axis, PulseCounts>> counts;
  const servo::PulseServo* servo = follower_.pulses();
  if (servo == nullptr) return counts;
  for (const base::Axis axis : base::all_axes) {
    if (const servo::PulseLoop* loop = servo->loop(axis))
      counts.emplace_back(axis, PulseCounts{loop->commanded(), loop->commanded_gross(), loop->encoder_count(),
                                            loop->encoder_gross(), loop->overflows(), loop->lost()});
  }
  return counts;
}

SlideFigures Slides::conclude() {
  SlideFigures figures;
  figures.verdict = referee_.conclude();
  contour_.rms = std::sqrt(contour_squares_ / static_cast<double>(std::max<std::int64_t>(1, contour_count_)));
  figures.contour = contour_;
  figures.feed = tracking_.feed();
  for (const base::Axis axis : base::all_axes) {
    if (axes_.contains(axis)) figures.axes.emplace_back(axis, tracking_.axis(axis));
  }
  figures.pulses = pulses();
  figures.settling = settling();
  return figures;
}

}  // namespace leadscrew::drive
