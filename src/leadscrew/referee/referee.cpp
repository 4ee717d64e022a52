#include <algorithm>
#include <cmath>
#include <leadscrew/referee/derivative_check.hpp>
#include <leadscrew/referee/feed_check.hpp>
#include <leadscrew/referee/feed_ripple.hpp>
#include <leadscrew/referee/matcher.hpp>
#include <leadscrew/referee/metric.hpp>
#include <leadscrew/referee/piece_source.hpp>
#include <leadscrew/referee/referee.hpp>
#include <leadscrew/referee/sampling_allowance.hpp>
#include <leadscrew/referee/stop_check.hpp>
#include <leadscrew/referee/violation_log.hpp>

namespace leadscrew::referee {

class Referee::Implementation {
 public:
  Implementation(MoveSource moves, const machine::Machine& machine, base::Period period,
                 std::function<bool()> cancelled)
      : metric_(machine),
        period_(period),
        source_(std::move(moves), metric_),
        cancellation_(std::move(cancelled)),
        matcher_(source_, metric_, cancellation_),
        allowance_(metric_, period.seconds()),
        derivatives_(machine, period),
        feed_(metric_, period),
        ripple_(period),
        stops_(metric_, period.seconds()) {}

  void observe(const base::AxisVector& position, std::optional<double> planned_feed) {
    if (cancellation_.requested()) return;
    if (!std::all_of(position.begin(), position.end(), [](double q) { return std::isfinite(q); })) {
      log_.add(time(), line_, "not a number", 0, 0);
      observe_finite(position_, planned_feed);
      return;
    }
    observe_finite(position, planned_feed);
  }

  MatchedBlock matched() const { return {line_, block_feed_}; }

  Verdict conclude() {
    Verdict verdict;
    if (words_ == 0) {
      log_.add(0, {}, "no words", 0, 0);
      log_.conclude(verdict);
      return verdict;
    }
    const double end_time = seconds(words_ - 1);
    verdict.time_s = end_time;
    if (const auto skipped = matcher_.conclude()) add_rare(end_time, "skipped path", *skipped);
    if (const auto passed = stops_.conclude()) add_rare(end_time, "stop", *passed);
    verdict.deviation_mm = matcher_.deviation();
    verdict.end_error_mm = metric_.distance(metric_.point(position_), matcher_.path_end());
    if (verdict.end_error_mm > source_.end_tolerance() + nanometre) {
      add_rare(end_time, "end", {source_.end_line(), verdict.end_error_mm, source_.end_tolerance()});
    }
    verdict.start_error_mm = start_error_;
    verdict.tolerance_mm = source_.largest_tolerance();
    verdict.feed_programmed_max = source_.greatest_feed();
    verdict.feed_max_ratio = feed_.greatest_ratio();
    verdict.feed_ripple = ripple_.greatest();
    derivatives_.conclude(line_, verdict, log_);
    log_.conclude(verdict);
    return verdict;
  }

 private:
  double seconds(std::int64_t words) const { return base::seconds(base::Tick{words}, period_); }
  double time() const { return seconds(words_); }

  void add_rare(double t, const char* what, const Finding& finding) {
    log_.add_rare(t, finding.line, what, finding.value, finding.limit);
  }

  void observe_finite(const base::AxisVector& position, std::optional<double> planned_feed) {
    const Point point = metric_.point(position);
    const Passage passage = words_ == 0 ? begin(point) : matcher_.observe(point, allowance_.observe(point));
    line_ = passage.line;
    block_feed_ = passage.block_feed;
    if (passage.skipped) add_rare(time(), "skipped path", *passage.skipped);
    if (const auto& departed = passage.deviation) {
      log_.add(time(), departed->line, "deviation", departed->value, departed->limit);
    }
    for (const RequiredStop& stop : source_.take_stops()) stops_.require(stop);
    stops_.observe(point);
    derivatives_.observe(position, line_);
    feed_.observe(position, passage, time(), log_);
    ripple_.observe(position, planned_feed, passage.feed);
    position_ = position;
    ++words_;
  }

  Passage begin(const Point& point) {
    const Passage passage = matcher_.begin(point);
    allowance_.begin(point);
    start_error_ = metric_.distance(point, matcher_.path_start());
    if (start_error_ > source_.start_tolerance() + nanometre) {
      add_rare(0, "start", {passage.line, start_error_, source_.start_tolerance()});
    }
    return passage;
  }

  Metric metric_;
  base::Period period_;
  PieceSource source_;
  Cancellation cancellation_;
  Matcher matcher_;
  SamplingAllowance allowance_;
  DerivativeCheck derivatives_;
  FeedCheck feed_;
  FeedRipple ripple_;
  StopCheck stops_;
  ViolationLog log_;
  std::int64_t words_ = 0;
  base::AxisVector position_{};
  base::Line line_{};
  double block_feed_ = 0;
  double start_error_ = 0;
};

Referee::Referee(MoveSource moves, const machine::Machine& machine, base::Period period,
                 std::function<bool()> cancelled)
    : implementation_(std::make_unique<Implementation>(std::move(moves), machine, period, std::move(cancelled))) {}
Referee::~Referee() = default;
Referee::Referee(Referee&&) noexcept = default;
Referee& Referee::operator=(Referee&&) noexcept = default;

void Referee::observe(const base::AxisVector& position, std::optional<double> planned_feed) {
  implementation_->observe(position, planned_feed);
}

MatchedBlock Referee::matched() const {
  return implementation_->matched();
}

Verdict Referee::conclude() {
  return implementation_->conclude();
}

}  // namespace leadscrew::referee
