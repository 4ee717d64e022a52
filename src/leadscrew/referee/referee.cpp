#include <algorithm>
#include <cmath>
#include <leadscrew/referee/derivative_check.hpp>
#include <leadscrew/referee/feed_check.hpp>
#include <leadscrew/referee/feed_ripple.hpp>
#include <leadscrew/referee/matcher.hpp>
#include <leadscrew/referee/metric.hpp>
#include <leadscrew/referee/piece_source.hpp>
#include <leadscrew/referee/pose.hpp>
#include <leadscrew/referee/referee.hpp>
#include <leadscrew/referee/sampling_allowance.hpp>
#include <leadscrew/referee/space.hpp>
#include <leadscrew/referee/stop_check.hpp>
#include <leadscrew/referee/violation_log.hpp>
#include <optional>

namespace leadscrew::referee {

namespace {

/// Words in one space, against the program's moves in it.
struct Section {
  PieceSource source;
  Matcher matcher;
  SamplingAllowance allowance;
  FeedCheck feed;
  FeedRipple ripple;
  StopCheck stops;
  bool has_rested = false;  ///< where it ends

  Section(Spaces& spaces, const Metric& metric, base::Period period, Cancellation& cancellation)
      : source([&spaces](gcode::Move& move) { return spaces.next(move); }, metric),
        matcher(source, metric, cancellation),
        allowance(metric, period.seconds(), spaces.space().is_of_tip),
        feed(metric, period),
        ripple(period),
        stops(metric, period.seconds(), spaces.space().is_of_tip) {}
};

}  // namespace

class Referee::Implementation {
 public:
  Implementation(MoveSource moves, const machine::Machine& machine, base::Period period,
                 std::function<bool()> cancelled)
      : metric_(machine),
        pose_(machine),
        period_(period),
        spaces_(std::move(moves)),
        cancellation_(std::move(cancelled)),
        derivatives_(machine, period) {}

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
    if (words_ == 0) {
      log_.add(0, {}, "no words", 0, 0);
      log_.conclude(verdict_);
      return verdict_;
    }
    const double end_time = seconds(words_ - 1);
    verdict_.time_s = end_time;
    conclude_section();
    const double end_tolerance = section_->source.end_tolerance();
    verdict_.end_error_mm = metric_.distance(point(position_), section_->matcher.path_end());
    if (verdict_.end_error_mm > end_tolerance + nanometre)
      add_rare(end_time, "end", {section_->source.end_line(), verdict_.end_error_mm, end_tolerance});
    while (spaces_.begin_next() && !cancellation_.requested()) skip_section(end_time);
    derivatives_.conclude(line_, verdict_, log_);
    log_.conclude(verdict_);
    return verdict_;
  }

 private:
  double seconds(std::int64_t words) const { return base::seconds(base::Tick{words}, period_); }
  double time() const { return seconds(words_); }

  void add_rare(double t, const char* what, const Finding& finding) {
    log_.add_rare(t, finding.line, what, finding.value, finding.limit);
  }

  base::AxisVector in_space(const base::AxisVector& position) const {
    const Space& space = spaces_.space();
    return space.is_of_tip ? pose_.tip_of(position, space.tool) : position;
  }
  Point point(const base::AxisVector& position) const { return metric_.point(in_space(position)); }

  /// What the section that ends has shown.
  void conclude_section() {
    const double t = seconds(words_ - 1);
    Section& section = *section_;
    if (const auto skipped = section.matcher.conclude()) add_rare(t, "skipped path", *skipped);
    if (const auto passed = section.stops.conclude()) add_rare(t, "stop", *passed);
    verdict_.deviation_mm = std::max(verdict_.deviation_mm, section.matcher.deviation());
    verdict_.tolerance_mm = std::max(verdict_.tolerance_mm, section.source.largest_tolerance());
    verdict_.feed_programmed_max = std::max(verdict_.feed_programmed_max, section.source.greatest_feed());
    verdict_.feed_max_ratio = std::max(verdict_.feed_max_ratio, section.feed.greatest_ratio());
    const std::optional<double> ripple = section.ripple.greatest();
    if (ripple) verdict_.feed_ripple = std::max(verdict_.feed_ripple.value_or(0), *ripple);
  }

  /// Of what no word has come to.
  void skip_section(double t) {
    PieceSource unvisited([this](gcode::Move& move) { return spaces_.next(move); }, metric_);
    Finding skipped;
    for (Piece piece; unvisited.next(piece) && !cancellation_.asked();) {
      const double distance = metric_.distance(unvisited.start(), piece.to);
      if (distance > skipped.value) skipped = {piece.line, distance, piece.tolerance};
    }
    if (skipped.value > skipped.limit + nanometre) add_rare(t, "skipped path", skipped);
  }

  /// Coordinates begin to mean something else where the motion rests. Does it rest where the section ends, between the
  /// word before and this one or a little earlier, and come no nearer to that place?
  bool ends_before(const base::AxisVector& position) {
    constexpr double near = 2, leaving = 16;  // steps
    if (!section_->source.any_move()) return spaces_.has_next();
    const double step = section_->stops.greatest_step();
    if (!section_->matcher.is_at_end(leaving * step) || !spaces_.has_next()) {
      section_->has_rested = false;
      return false;
    }
    const Point here = point(position), &end = section_->source.end();
    const double before = metric_.distance(point(position_), end);
    if (before <= near * step && section_->stops.is_rest(metric_.point(position_), metric_.point(position)))
      section_->has_rested = true;
    return section_->has_rested && (metric_.distance(here, end) >= before || !section_->matcher.is_on_last_piece(here));
  }

  void observe_finite(const base::AxisVector& position, std::optional<double> planned_feed) {
    if (words_ == 0) {
      spaces_.begin_next();
      begin_section();
      observe_first(position);
    } else {
      while (ends_before(position)) change_space();
      observe_next(position, planned_feed);
    }
    derivatives_.observe(position, line_);
    position_ = position;
    ++words_;
  }

  void begin_section() { section_.emplace(spaces_, metric_, period_, cancellation_); }

  /// The motion is there, be it between two words: it belongs to both sections.
  void change_space() {
    const Point end = section_->source.end();
    if (section_->source.any_move()) account(section_->matcher.observe(end, section_->allowance.observe(end)));
    conclude_section();
    spaces_.begin_next();
    const base::AxisVector rest = spaces_.start();
    const Point start = metric_.point(rest);
    begin_section();
    const Passage passage = section_->matcher.begin(start);
    account(passage);
    section_->allowance.begin(start);
    section_->stops.observe(start, metric_.point(position_));
    section_->feed.observe(rest, passage, time(), log_);
  }

  void observe_first(const base::AxisVector& position) {
    const Passage passage = section_->matcher.begin(point(position));
    section_->allowance.begin(point(position));
    verdict_.start_error_mm = metric_.distance(point(position), section_->matcher.path_start());
    if (verdict_.start_error_mm > section_->source.start_tolerance() + nanometre)
      add_rare(0, "start", {passage.line, verdict_.start_error_mm, section_->source.start_tolerance()});
    observe_passage(position, passage, {});
  }

  void observe_next(const base::AxisVector& position, std::optional<double> planned_feed) {
    const Point place = point(position);
    observe_passage(position, section_->matcher.observe(place, section_->allowance.observe(place)), planned_feed);
  }

  void account(const Passage& passage) {
    line_ = passage.line;
    block_feed_ = passage.block_feed;
    if (passage.skipped) add_rare(time(), "skipped path", *passage.skipped);
    if (const auto& departed = passage.deviation)
      log_.add(time(), departed->line, "deviation", departed->value, departed->limit);
    for (const RequiredStop& stop : section_->source.take_stops()) section_->stops.require(stop);
  }

  void observe_passage(const base::AxisVector& position, const Passage& passage, std::optional<double> planned_feed) {
    account(passage);
    const base::AxisVector place = in_space(position);
    section_->stops.observe(metric_.point(place), metric_.point(position));
    section_->feed.observe(place, passage, time(), log_);
    section_->ripple.observe(place, planned_feed, passage.feed);
  }

  Metric metric_;
  Pose pose_;
  base::Period period_;
  Spaces spaces_;
  Cancellation cancellation_;
  std::optional<Section> section_;
  DerivativeCheck derivatives_;
  ViolationLog log_;
  Verdict verdict_;
  std::int64_t words_ = 0;
  base::AxisVector position_{};
  base::Line line_{};
  double block_feed_ = 0;
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
