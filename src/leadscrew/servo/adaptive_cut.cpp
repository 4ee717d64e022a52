#include <algorithm>
#include <cmath>
#include <leadscrew/servo/adaptive_cut.hpp>
#include <leadscrew/servo/refusal.hpp>
#include <numeric>
#include <utility>

namespace leadscrew::servo {

namespace {

constexpr double sample_time = 1e-3;  // s
constexpr int parts_of_a_tooth = 32;
constexpr double fastest_cut = 3;  // times what is programmed: beyond, motion is rapid

struct Window {
  int samples = 1;  // to each change of the override
  int window = 1;
};

/// So many samples that they are whole tooth passings within 2 %, or as nearly as any up to 200; in as many parts as
/// there can be.
Window window_of(double samples_a_tooth) {
  constexpr int most = 200, most_parts = 16;
  int best = 1;
  double least = 1;
  for (int count = 1; count <= most && least > 0.02; ++count) {
    const double teeth = count / samples_a_tooth;
    if (teeth < 0.98 || count < 4) continue;
    const double off = std::fabs(teeth - std::round(teeth)) / std::round(teeth);
    if (off < least) {
      least = off;
      best = count;
    }
  }
  int parts = std::min(most_parts, best);
  while (best % parts != 0) --parts;
  return {best / parts, parts};
}

int at_least_one(double value) {
  return std::max(1, static_cast<int>(std::lround(std::min(value, 1e6))));
}

}  // namespace

base::Result<AdaptiveCut> AdaptiveCut::create(const AdaptiveCutOptions& options, double period) {
  Refusal refusal("servo-cut");
  refusal.unless_positive("the period", period);
  refusal.unless_within("the width of the cut", options.width, 0, options.milling.diameter);
  refusal.unless_positive("the safe override", options.safe);
  double from = 0;
  for (const DepthStep& step : options.depths) {
    refusal.unless_not_negative("a depth of the cut", step.depth);
    refusal.unless_within("the place of a depth", step.from, from, 1e12);
    from = step.from;
  }
  if (refusal.found()) return base::failure(*refusal.found());
  auto mill = MillingForce::create(options.milling);
  if (!mill) return base::failure(std::move(mill.error()));
  const int periods = at_least_one(sample_time / period);
  AdaptiveFeedOptions feed{.limit = options.limit, .sample_period = periods * period, .safe = options.safe};
  const double tooth = 1 / (options.milling.spindle_speed * options.milling.teeth);
  const Window window = window_of(tooth / feed.sample_period);
  feed.samples = window.samples;
  feed.window = window.window;
  feed.sensor_range = std::max(feed.sensor_range, 20 * options.limit);
  feed.silent_after = std::max(feed.silent_after, feed.sample_period);
  if (options.milling.noise == 0) feed.stuck_after = 0;
  auto control = AdaptiveFeed::create(feed);
  if (!control) return base::failure(std::move(control.error()));
  return AdaptiveCut(options, std::move(*mill), std::move(*control), period);
}

AdaptiveCut::AdaptiveCut(const AdaptiveCutOptions& options, MillingForce mill, AdaptiveFeed control, double period)
    : options_(options),
      mill_(std::move(mill)),
      control_(std::move(control)),
      period_(period),
      parts_(std::max(1, static_cast<int>(std::ceil(period * options.milling.spindle_speed * options.milling.teeth *
                                                    parts_of_a_tooth)))),
      periods_a_sample_(at_least_one(sample_time / period)),
      turn_(static_cast<std::size_t>(at_least_one(turn() / period)), 0.0) {}

double AdaptiveCut::follow(double feed, double programmed, double travel) {
  const bool cuts = programmed > 0 && feed <= fastest_cut * programmed;
  const double force = cut(cuts ? feed : 0, travel);
  judge(force);
  ++periods_;
  if (!cuts) return feed_override();
  force_sum_ += force;
  share_sum_ += feed / programmed;
  if (++gathered_ == periods_a_sample_) {
    control_.sample(sensed(force_sum_ / gathered_), share_sum_ / gathered_);
    force_sum_ = share_sum_ = gathered_ = 0;
  }
  account();
  return feed_override();
}

/// Mean force of the period, N.
double AdaptiveCut::cut(double feed, double travel) {
  while (depth_ + 1 < options_.depths.size() && options_.depths[depth_ + 1].from <= travel) ++depth_;
  Engagement engagement{0, options_.width};
  if (!options_.depths.empty() && feed > 0) engagement.depth = options_.depths[depth_].depth;
  double sum = 0;
  for (int part = 0; part < parts_; ++part) sum += mill_.after(period_ / parts_, feed, engagement);
  return sum / parts_;
}

void AdaptiveCut::judge(double force) {
  constexpr double allowed = 1.25;
  const std::size_t place = static_cast<std::size_t>(periods_) % turn_.size();
  turn_sum_ += force - std::exchange(turn_[place], force);
  if (place == 0) turn_sum_ = std::accumulate(turn_.begin(), turn_.end(), 0.0);  // so that rounding does not accumulate
  mean_ = turn_sum_ / static_cast<double>(turn_.size());
  figures_.greatest_mean = std::max(figures_.greatest_mean, mean_);
  excess_ = mean_ > allowed * options_.limit ? excess_ + period_ : 0;
  figures_.longest_excess = std::max(figures_.longest_excess, excess_);
}

std::optional<double> AdaptiveCut::sensed(double force) {
  const bool failed = options_.fault && static_cast<double>(periods_) * period_ >= options_.fault->at;
  if (failed && options_.fault->kind == SensorFailure::silent) return std::nullopt;
  if (failed && options_.fault->kind == SensorFailure::not_a_number) return std::nan("");
  if (failed && last_sensed_) return last_sensed_;
  return last_sensed_ = force;
}

void AdaptiveCut::account() {
  if (control_.failure() != SensorFailure::none && !figures_.failed_at)
    figures_.failed_at = static_cast<double>(periods_) * period_;
  figures_.least_override = std::min(figures_.least_override, feed_override());
  figures_.greatest_override = std::max(figures_.greatest_override, feed_override());
  if (control_.above_limit_at_least()) figures_.unreachable += period_;
  override_sum_ += feed_override();
  ++cutting_;
}

CutFigures AdaptiveCut::figures() const {
  CutFigures figures = figures_;
  if (cutting_ > 0) figures.mean_override = override_sum_ / static_cast<double>(cutting_);
  return figures;
}

}  // namespace leadscrew::servo
