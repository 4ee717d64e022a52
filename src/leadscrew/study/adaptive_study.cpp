#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/study/adaptive_slot.hpp>
#include <leadscrew/study/studies.hpp>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

// A slot in steel whose depth changes along it, milled with adaptive control: by the planner's feed override, and
// by the adaptive-control input of Koren's NC program. The limit of the force is what the programmed feed gives in a
// depth of 2 mm:
//
//   depth      2      4      2      1.25     2.5       0.5      2     mm
//           ├──────┼──────┼──────┼────────┼──────┼────────────┼──────┤
//   override  100    50     100    160      80        200       100   %, 2 mm/depth, at most 200 %

namespace leadscrew::study {

namespace {

constexpr double limiting_depth = 2, width = 4;  // mm
constexpr double safe = 0.5, most = 2;           // overrides
constexpr double noise = 0.1;                    // of the limit
constexpr double fails_at = 0.9;                 // s

struct Part {
  double from = 0, to = 0;  ///< mm
  double depth = 0;         ///< mm

  double override_held() const { return std::min(limiting_depth / depth, most); }
};
constexpr std::array<Part, 7> parts = {
    {{0, 12, 2}, {12, 24, 4}, {24, 36, 2}, {36, 52, 1.25}, {52, 64, 2.5}, {64, 88, 0.5}, {88, 100, 2}}};
constexpr double length = parts.back().to, failing_length = parts[1].to;

servo::AdaptiveCutOptions options_with(double noise_share, std::optional<servo::SensorFault> fault) {
  servo::AdaptiveCutOptions options;
  options.milling.cutting_coefficient = 2000;
  options.width = width;
  for (const Part& part : parts) options.depths.push_back({part.from, part.depth});
  const auto mill = servo::MillingForce::create(options.milling);
  options.limit = mill ? mill->mean(slot_feed, {limiting_depth, width}) : 1;
  options.milling.noise = noise_share * options.limit;
  options.safe = safe;
  options.fault = fault;
  return options;
}

/// Of the last third of a part, less where the slide may brake.
struct Settled {
  double factor = 0, feed = 0, force = 0;  ///< mean override, mm/s, N
  double swing = 0;                        ///< standard deviation of the override over its mean
};

Settled settled(const MilledSlot& milled, const Part& part) {
  Settled sums;
  double squares = 0, count = 0;
  for (const SlotPeriod& at : milled.periods) {
    if (at.position < part.to - (part.to - part.from) / 3 || at.position > part.to - 1) continue;
    sums.factor += at.factor;
    sums.feed += at.feed;
    sums.force += at.mean_force;
    squares += at.factor * at.factor;
    ++count;
  }
  if (count == 0) return sums;
  const double mean = sums.factor / count, variance = std::max(0.0, squares / count - mean * mean);
  return {mean, sums.feed / count, sums.force / count, std::sqrt(variance) / mean};
}

/// Greatest of all parts whose override is not at its greatest.
double greatest_swing(const MilledSlot& milled) {
  double greatest = 0;
  for (const Part& part : parts) {
    if (part.override_held() < most) greatest = std::max(greatest, settled(milled, part).swing);
  }
  return greatest;
}

/// The mean that is controlled is of at least 32 forces, a passing of a tooth, each with noise of its own; steady means
/// of means swing no more than these do.
double explained_swing() {
  return noise / std::sqrt(32.0);
}

Rows override_rows(const MilledSlot& milled) {
  Rows rows;
  for (const Part& part : parts) {
    const std::string name =
        "override from " + decimal(part.from, 0) + " mm on, " + decimal(part.depth, 2) + " mm deep";
    rows.push_back(reproduced_row(name, {"%", 0}, 100 * part.override_held(), 100 * settled(milled, part).factor, 2));
  }
  rows.front() = because(std::move(rows.front()), "settled; 2 mm over the depth, at most 200 %");
  return rows;
}

/// How far from the limit the mean force is where the override is not at its greatest, share of the limit.
double greatest_departure(const MilledSlot& milled, double limit) {
  double greatest = 0;
  for (const Part& part : parts) {
    if (part.override_held() < most) greatest = std::max(greatest, std::fabs(settled(milled, part).force / limit - 1));
  }
  return greatest;
}

Rows failing_rows(Overridden overridden) {
  Rows rows;
  for (const servo::SensorFailure kind :
       {servo::SensorFailure::not_a_number, servo::SensorFailure::stuck, servo::SensorFailure::silent}) {
    const std::string name = "sensor " + std::string(servo::name(kind)) + ": ";
    const auto milled = mill_slot(overridden, failing_length, options_with(noise, servo::SensorFault{kind, fails_at}));
    if (!milled || milled->failure != kind) {
      rows.push_back(not_run_row(name + "feed", milled ? "the failure was not seen" : milled.error().message));
      continue;
    }
    const double taken = milled->cut.failed_at.value_or(1e9) - fails_at;
    const Settled after = settled(*milled, parts[1]);
    rows.push_back(limit_row(name + "not believed after", {"ms", 0}, 20, taken * 1000, 1));
    rows.push_back(exact_row(name + "override from there", {"", 2}, safe, milled->periods.back().factor));
    rows.push_back(reproduced_row(name + "feed from there", {"mm/s", 2}, safe * slot_feed, after.feed, 0.02));
  }
  return rows;
}

Rows rows_of(Overridden overridden, const std::string& group) {
  const servo::AdaptiveCutOptions options = options_with(noise, {});
  const auto noisy = mill_slot(overridden, length, options), quiet = mill_slot(overridden, length, options_with(0, {}));
  const auto safe_time = slot_time(overridden, length, safe);
  if (!noisy || !quiet) return under(group, {not_run_row("force", (noisy ? quiet : noisy).error().message)});
  if (!safe_time) return under(group, {not_run_row("time", safe_time.error().message)});
  Rows rows = override_rows(*noisy);
  append(
      rows,
      {because(limit_row("mean force, off the limit by", {"%", 1}, 2, 100 * greatest_departure(*noisy, options.limit)),
               "settled, in parts below 200 %"),
       because(limit_row("force beyond 1.25 limits at a stretch", {"ms", 0}, 150, noisy->cut.longest_excess * 1000),
               "mean over a turn; 150 ms or two turns of 20 ms, whichever is longer"),
       measured_row("greatest mean force over a turn", {"% of the limit", 0},
                    noisy->cut.greatest_mean / options.limit * 100),
       because(limit_row("swing of the override, noise 10 %", {"%", 2}, 100 * explained_swing(),
                         100 * greatest_swing(*noisy)),
               "settled, standard deviation; limit: of the mean of 32 forces, 10 %/√32"),
       because(limit_row("swing of the override, no noise", {"%", 2}, 0.1, 100 * greatest_swing(*quiet)),
               "no limit cycle"),
       because(limit_row("time", {"s", 2}, *safe_time, noisy->time()),
               "beside the constant safe feed, 50 %, that the deepest part allows"),
       measured_row("time saved", {"%", 1}, (1 - noisy->time() / *safe_time) * 100)});
  append(rows, failing_rows(overridden));
  return under(group, std::move(rows));
}

}  // namespace

Rows adaptive_rows(const Host&) {
  Rows rows = rows_of(Overridden::planner, "override of the planner, 10 mm/s");
  append(rows, rows_of(Overridden::nc_program, "override of the NC program, 10 mm/s"));
  return rows;
}

}  // namespace leadscrew::study
