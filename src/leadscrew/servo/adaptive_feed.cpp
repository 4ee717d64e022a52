#include <algorithm>
#include <cmath>
#include <leadscrew/servo/adaptive_feed.hpp>
#include <leadscrew/servo/refusal.hpp>

namespace leadscrew::servo {

namespace {

constexpr double least_feed = 0.01;   // share of the programmed one; below it force over feed is not used
constexpr double least_force = 0.05;  // share of the limit; below it, force is not taken for cutting

}  // namespace

std::string_view name(SensorFailure failure) {
  switch (failure) {
    case SensorFailure::none:
      return "none";
    case SensorFailure::not_a_number:
      return "not a number";
    case SensorFailure::out_of_range:
      return "out of range";
    case SensorFailure::stuck:
      return "stuck";
    case SensorFailure::silent:
      return "silent";
  }
  return "";
}

base::Result<AdaptiveFeed> AdaptiveFeed::create(const AdaptiveFeedOptions& options) {
  constexpr int many = 100000;
  Refusal refusal("servo-adaptive-feed");
  refusal.unless_positive("the limit of the force", options.limit);
  refusal.unless_positive("the sample period", options.sample_period);
  refusal.unless_within("the number of samples", options.samples, 1, many);
  refusal.unless_within("the window", options.window, 1, longest_window);
  refusal.unless_positive("the share of a new stiffness", options.share);
  refusal.unless_within("the share of a new stiffness", options.share, 0, 1);
  refusal.unless_positive("the least override", options.least);
  refusal.unless_within("the greatest override", options.most, options.least, 2);
  refusal.unless_positive("the rise of the override", options.rise);
  refusal.unless_within("the safe override", options.safe, 0, 1);
  refusal.unless_positive("the sensor's range less the limit", options.sensor_range - options.limit);
  refusal.unless_within("the time of silence", options.silent_after, options.sample_period, 3600);
  if (options.stuck_after != 0) refusal.unless_within("the number of samples alike", options.stuck_after, 2, many);
  if (refusal.found()) return base::failure(*refusal.found());
  return AdaptiveFeed(options);
}

double AdaptiveFeed::sample(std::optional<double> force, double feed_share) {
  if (failure_ != SensorFailure::none) return override_;
  const SensorFailure seen = examine(force);
  if (seen != SensorFailure::none) {
    // A sample that is missing is waited for; meanwhile the override stays.
    const bool waits = seen != SensorFailure::stuck && silent_ * options_.sample_period < options_.silent_after;
    if (waits) return override_;
    failure_ = seen;
    return override_ = options_.safe;
  }
  Sums& sums = sums_[newest_];
  sums.force += *force;
  sums.feed += feed_share;
  sums.force_and_feed += *force * feed_share;
  if (++sums.samples == options_.samples) change_override();
  const double target = std::clamp(wanted_, options_.least, options_.most);
  return override_ = std::min(target, override_ + options_.rise * options_.sample_period);
}

/// What is wrong with this sample, and for how long samples have been wrong.
SensorFailure AdaptiveFeed::examine(std::optional<double> force) {
  ++silent_;
  if (!force) return SensorFailure::silent;
  if (std::isnan(*force)) return SensorFailure::not_a_number;
  if (!(std::fabs(*force) <= options_.sensor_range)) return SensorFailure::out_of_range;
  silent_ = 0;
  alike_ = *force == last_force_ ? std::min(alike_, options_.stuck_after) + 1 : 1;
  last_force_ = *force;
  const bool is_stuck = options_.stuck_after != 0 && alike_ >= options_.stuck_after;
  return is_stuck ? SensorFailure::stuck : SensorFailure::none;
}

void AdaptiveFeed::change_override() {
  if (const auto seen = stiffness_seen()) {
    const bool at_once = !stiffness_ || *seen > *stiffness_;
    stiffness_ = at_once ? *seen : *stiffness_ + options_.share * (*seen - *stiffness_);
    wanted_ = *stiffness_ > 0 ? options_.limit / *stiffness_ : options_.most;
  }
  newest_ = (newest_ + 1) % static_cast<std::size_t>(options_.window);
  sums_[newest_] = {};
}

/// Over the window; empty before the first is full, and where there was next to no feed, or too little force to tell of
/// more stiffness than is known.
std::optional<double> AdaptiveFeed::stiffness_seen() const {
  Sums all;
  for (const Sums& sums : sums_) {
    all.force += sums.force;
    all.feed += sums.feed;
    all.force_and_feed += sums.force_and_feed;
    all.samples += sums.samples;
  }
  if (all.samples < options_.window * options_.samples) return std::nullopt;
  const double force = std::max(all.force / all.samples, 0.0);
  const bool cuts = force > least_force * options_.limit;
  const double feed = cuts ? all.force_and_feed / all.force : all.feed / all.samples;
  if (!(feed > least_feed)) return std::nullopt;
  const double seen = force / feed;
  // While the feed changes, force without its teeth may tell of too much stiffness, and there is no danger in it.
  if (!cuts && stiffness_ && seen > *stiffness_) return std::nullopt;
  return seen;
}

void AdaptiveFeed::restart() {
  *this = AdaptiveFeed(options_);
}

}  // namespace leadscrew::servo
