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
  Metric metric;
  bool is_of_tip;
  PieceSource source;
  Matcher matcher;
  SamplingAllowance allowance;
  FeedCheck feed;
  FeedRipple ripple;
  StopCheck stops;
  bool has_rested = false;  ///< where it ends

  Section(Spaces& spaces, const machine::Machine& machine, base::Period period, Cancellation& cancellation)
      : metric(machine, spaces.per_degree()),
        is_of_tip(spaces.space().is_of_tip),
        source([&spaces](gcode::Move& move) { return spaces.next(move); }, metric, machine.threads_follow()),
        matcher(source, metric, cancellation, is_of_tip),
        allowance(metric, period.seconds()),
        feed(metric, period),
        ripple(period),
        stops(metric, period.seconds(), is_of_tip) {}
};

/// Of a word, from the place of the path that it is matched to.
struct PoseDeviation {
  double tip = 0;        ///< mm
  double direction = 0;  ///< degrees
};

constexpr double direction_rounding = 1e-9;  // degrees

}  // namespace

class Referee::Implementation {
 public:
  Implementation(MoveSource moves, const machine::Machine& machine, base::Period period,
                 std::function<bool()> cancelled)
      : machine_(machine),
        pose_(machine),
        period_(period),
        spaces_(std::move(moves)),
        cancellation_(std::move(cancelled)),
        tip_allowance_(machine, pose_, period.seconds()),
        derivatives_(machine, period) {}

  void observe(const base::AxisVector& position, std::optional<double> planned_feed) {
    if (cancellation_.requested()) return;
    if (!std::all_of(position.begin(), position.end(), [](double q) { return std::isfinite(q); })) {
      log_.add(time(), matched_.line, "not a number", 0, 0);
      observe_finite(position_, planned_feed);
      return;
    }
    observe_finite(position, planned_feed);
  }

  const MatchedBlock& matched() const { return matched_; }

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
    verdict_.end_error_mm = section_->metric.distance(point(position_), section_->matcher.path_end());
    if (verdict_.end_error_mm > end_tolerance + nanometre)
      add_rare(end_time, "end", {section_->source.end_line(), verdict_.end_error_mm, end_tolerance});
    while (spaces_.begin_next() && !cancellation_.requested()) skip_section(end_time);
    derivatives_.conclude(matched_.line, verdict_, log_);
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
  Point point(const base::AxisVector& position) const { return section_->metric.point(in_space(position)); }

  /// What the section that ends has shown.
  void conclude_section() {
    const double t = seconds(words_ - 1);
    Section& section = *section_;
    if (const auto skipped = section.matcher.conclude()) add_rare(t, "skipped path", *skipped);
    if (const auto passed = section.stops.conclude()) add_rare(t, "stop", *passed);
    verdict_.deviation_mm = std::max(verdict_.deviation_mm, section.matcher.deviation());
    verdict_.tolerance_mm = std::max(verdict_.tolerance_mm, section.source.largest_tolerance());
    if (section.is_of_tip) {
      verdict_.orientation_tolerance_deg =
          std::max(verdict_.orientation_tolerance_deg, section.source.largest_orientation_tolerance());
    }
    verdict_.feed_programmed_max = std::max(verdict_.feed_programmed_max, section.source.greatest_feed());
    verdict_.feed_max_ratio = std::max(verdict_.feed_max_ratio, section.feed.greatest_ratio());
    const std::optional<double> ripple = section.ripple.greatest();
    if (ripple) verdict_.feed_ripple = std::max(verdict_.feed_ripple.value_or(0), *ripple);
  }

  /// Of what no word has come to.
  void skip_section(double t) {
    const Metric metric(machine_, spaces_.per_degree());
    PieceSource unvisited([this](gcode::Move& move) { return spaces_.next(move); }, metric, machine_.threads_follow());
    Finding skipped;
    for (Piece piece; unvisited.next(piece) && !cancellation_.asked();) {
      const double distance = metric.distance(unvisited.start(), piece.to);
      if (distance > skipped.value) skipped = {piece.line, distance, piece.tolerance};
    }
    if (skipped.value > skipped.limit + nanometre) add_rare(t, "skipped path", skipped);
  }

  /// Coordinates begin to mean something else where the motion rests. Does it rest where the section ends, between the
  /// word before and this one or a little earlier, and go no farther towards that place? Where all words are so slow and so
  /// near to it that any two might be at rest, only that tells.
  bool ends_before(const base::AxisVector& position) {
    constexpr double near = 2, leaving = 16;   // steps
    constexpr double farthest_departure = 10;  // mm
    if (!section_->source.any_move()) return spaces_.has_next();
    const double step = section_->stops.greatest_step();
    // A trace that lies beside the program all along comes to its ends beside it.
    const double off = std::min(section_->matcher.departure(), farthest_departure) + section_->source.end_tolerance();
    const double beside = section_->matcher.departure() > 0 ? off : 0;
    if (!section_->matcher.is_at_end(leaving * step + beside) || !spaces_.has_next()) {
      section_->has_rested = false;
      return false;
    }
    const Metric& metric = section_->metric;
    const Point here = point(position), &end = section_->source.end();
    const double before = metric.distance(point(position_), end);
    if (before <= near * step + beside && section_->stops.is_rest(metric.point(position_), metric.point(position)))
      section_->has_rested = true;
    if (!section_->has_rested) return false;
    // Held a little before the end it may yet go on.
    const bool stays = here == point(position_) && before > section_->source.end_tolerance() + nanometre + beside;
    Section& section = *section_;
    const double allowed = section.is_of_tip ? tip_allowance() : SamplingAllowance(section.allowance).observe(here);
    return !stays && !section.matcher.leads_on(here, allowed);
  }

  void observe_finite(const base::AxisVector& position, std::optional<double> planned_feed) {
    if (words_ == 0) {
      position_ = word_ = position;
      spaces_.begin_next();
      begin_section();
      observe_first(position);
    } else {
      word_ = position;
      while (ends_before(position)) change_space();
      observe_next(position, planned_feed);
    }
    derivatives_.observe(position, matched_.line);
    before_ = words_ == 0 ? position : position_;
    position_ = position;
    ++words_;
  }

  double tip_allowance() const {
    return tip_allowance_.of(before_, position_, word_, section_->metric, spaces_.space().tool);
  }
  /// For the chord from the place before to this one, which is a word or a place that motion passes before it.
  double allowance_to(const Point& place) {
    return section_->is_of_tip ? tip_allowance() : section_->allowance.observe(place);
  }

  void begin_section() { section_.emplace(spaces_, machine_, period_, cancellation_); }

  /// The motion is there, be it between two words: it belongs to both sections.
  void change_space() {
    const Point end = section_->source.end();
    if (section_->source.any_move()) {
      account(section_->matcher.observe(end, allowance_to(end)), section_->metric.position(end));
    }
    conclude_section();
    spaces_.begin_next();
    const base::AxisVector rest = spaces_.start();
    begin_section();
    const Point start = section_->metric.point(rest);
    const Passage passage = section_->matcher.begin(start);
    account(passage, rest);
    section_->allowance.begin(start);
    section_->stops.observe(start, section_->metric.point(position_));
    section_->feed.observe(rest, passage, time(), log_);
  }

  void observe_first(const base::AxisVector& position) {
    const Passage passage = section_->matcher.begin(point(position));
    section_->allowance.begin(point(position));
    verdict_.start_error_mm = section_->metric.distance(point(position), section_->matcher.path_start());
    if (verdict_.start_error_mm > section_->source.start_tolerance() + nanometre)
      add_rare(0, "start", {passage.line, verdict_.start_error_mm, section_->source.start_tolerance()});
    observe_passage(position, passage, {});
  }

  void observe_next(const base::AxisVector& position, std::optional<double> planned_feed) {
    const Point place = point(position);
    observe_passage(position, section_->matcher.observe(place, allowance_to(place)), planned_feed);
  }

  /// Of the tip and of the tool's direction apart: both hang on a place in one metric, so that the match is one.
  PoseDeviation deviation_of(const Passage& passage, const base::AxisVector& place) {
    const base::AxisVector matched = section_->metric.position(passage.place);
    const PoseDeviation found{std::hypot(place[0] - matched[0], place[1] - matched[1], place[2] - matched[2]),
                              angle_between(pose_.direction_of(place), pose_.direction_of(matched))};
    verdict_.tip_deviation_mm = std::max(verdict_.tip_deviation_mm.value_or(0), found.tip);
    verdict_.orientation_deviation_deg = std::max(verdict_.orientation_deviation_deg.value_or(0), found.direction);
    return found;
  }

  /// What it is that leaves the path: the tool's direction, the tip, or both together.
  void tell_departure(const Passage& passage, const PoseDeviation& pose) {
    const Finding& departed = *passage.deviation;
    const double most = passage.orientation_tolerance;
    const bool turned = section_->is_of_tip && pose.direction > most + direction_rounding;
    const bool is_off = section_->is_of_tip && pose.tip > departed.limit + nanometre;
    if (turned) log_.add(time(), departed.line, "orientation", pose.direction, most);
    if (is_off || !turned)
      log_.add(time(), departed.line, "deviation", is_off ? pose.tip : departed.value, departed.limit);
  }

  /// `place`: the word's, in its space.
  void account(const Passage& passage, const base::AxisVector& place) {
    const PoseDeviation pose = section_->is_of_tip ? deviation_of(passage, place) : PoseDeviation();
    matched_ = {passage.line, passage.block_feed, passage.tool, section_->is_of_tip ? pose.tip : passage.distance,
                passage.tolerance};
    if (passage.skipped) add_rare(time(), "skipped path", *passage.skipped);
    if (passage.deviation) tell_departure(passage, pose);
    for (const RequiredStop& stop : section_->source.take_stops()) section_->stops.require(stop);
  }

  void observe_passage(const base::AxisVector& position, const Passage& passage, std::optional<double> planned_feed) {
    const base::AxisVector place = in_space(position);
    account(passage, place);
    section_->stops.observe(section_->metric.point(place), section_->metric.point(position));
    section_->feed.observe(place, passage, time(), log_);
    const bool is_of_tip = !passage.feed.is_of_contact;
    section_->ripple.observe(place, is_of_tip ? planned_feed : std::nullopt, passage.feed);
  }

  const machine::Machine& machine_;
  Pose pose_;
  base::Period period_;
  Spaces spaces_;
  Cancellation cancellation_;
  TipAllowance tip_allowance_;
  std::optional<Section> section_;
  DerivativeCheck derivatives_;
  ViolationLog log_;
  Verdict verdict_;
  std::int64_t words_ = 0;
  base::AxisVector before_{}, position_{}, word_{};  ///< the last words, and the one that is observed
  MatchedBlock matched_;
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
