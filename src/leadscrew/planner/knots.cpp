#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/planner/knot_samples.hpp>
#include <leadscrew/planner/knots.hpp>
#include <leadscrew/planner/tuning.hpp>
#include <limits>

namespace leadscrew::planner {

namespace {

using Sample = KnotSample;
using namespace tuning::knots;

constexpr double infinity = std::numeric_limits<double>::infinity();

class Placement {
 public:
  Placement(const Section& section, const constraints::Constraints& constraints, const PlannedRange& range,
            std::size_t most, Effort& effort)
      : section_(section), constraints_(constraints), range_(range), most_(most), effort_(effort) {}

  Knots place() {
    if (!range_.starts_at_rest) keep();
    if (range_.kept_end_ramp > 0) {
      knots_.end_ramp = range_.kept_end_ramp;
      knots_.intervals = knots_.s.size() - 1;
      return std::move(knots_);
    }
    kept_ = knots_.s.size();
    ramps();
    find_breaks();
    sample();
    if (!effort_.goes_on()) return {};
    if (!samples_.empty()) place_new();
    // What is kept may reach to rest already: a window of more knots than one may have ended in motion before it.
    if (range_.ends_at_rest && kept_ > 0 && knots_.s.size() == kept_) knots_.end_ramp = range_.end - knots_.s.back();
    if (!range_.ends_at_rest || !reaches_end_ || knots_.s.size() > most() + rest_knots)
      cut();
    else
      knots_.intervals = knots_.s.size() - 1;
    return std::move(knots_);
  }

 private:
  /// First and last interval: t₁ about a hundredth of the time in which acceleration is reached, so short that
  /// direction does not turn.
  void ramps() {
    const auto ramp = [&](double s, Side side) {
      const SeenPlace seen = section_.see(s, side);
      const geometry::PointJet& jet = seen.jet;
      const machine::Derivatives t = tangent_limits(jet, constraints_);
      const double speed = std::sqrt(constraints_.greatest_square(seen.at_feed(range_.feed_factor)));
      // Where jerk is next to no limit, what counts is how long speed rises: far less than that is short enough.
      const double rise = std::min(speed / t.acceleration, std::sqrt(length() / t.acceleration));
      const double time = 0.01 * std::min({std::max(t.acceleration / t.jerk, 0.02 * rise), std::sqrt(speed / t.jerk),
                                           numeric::cbrt(length() / (2 * t.jerk))});
      double bend = 0;
      for (const numeric::Jet<>& q : jet) bend = std::max(bend, std::abs(q.second) / std::max(std::abs(q.first), 1e-3));
      double ramp_length = std::min(t.jerk * time, t.acceleration) * time * time / 6;
      if (bend > 0) ramp_length = std::min(ramp_length, 5e-5 / bend);
      return std::max(std::min(ramp_length, 1e-3 * length()), shortest_ramp * s);
    };
    if (range_.starts_at_rest) knots_.start_ramp = ramp(range_.begin, Side::right);
    knots_.end_ramp = ramp(range_.end, Side::left);
  }
  double length() const { return range_.end - range_.begin; }
  std::size_t most() const {
    if (kept_ == 0) return most_;
    if (range_.changes_from == 0) return std::max(most_, std::min(kept_ + more_knots, most_ + rest_knots));
    // What is kept of a creep is short: from the speed that comes now, it takes all knots beyond to come to rest.
    return std::max(most_, std::min(kept_ + rest_knots, more_windows * most_ + rest_knots));
  }
  /// To the nearest place of rest. What lies beyond a stretch that ends in motion may force a stop there.
  double from_rest(double s) const {
    const double before_end = range_.end - s;
    return range_.starts_at_rest ? std::min(s - range_.begin, before_end) : before_end;
  }

  void find_breaks() {
    const double end = range_.end - knots_.end_ramp;
    const auto add = [&](double s) {
      if (s > range_.begin && s < end) breaks_.push_back(s);
    };
    for (std::size_t p = section_.piece_at(range_.begin, Side::right); p < section_.size(); ++p) {
      if (section_.offset(p) >= end) break;
      const toolpath::Piece& piece = section_.piece(p);
      for (const double s : piece.axes().breaks()) {
        const double at = section_.offset(p) + s;
        if (at > range_.begin && at < end && is_noticed(piece, s)) breaks_.push_back(at);
      }
      if (p + 1 < section_.size() && jumps(p)) add(section_.offset(p + 1));
    }
    breaks_.push_back(end);
  }

  /// Whether q‴ steps by more than jerk notices, as fast as motion may be there. Of a path of least time that is smooth for long,
  /// every knot is a break: with knots of x at each, a window would not reach as far as it takes to stop.
  bool is_noticed(const toolpath::Piece& piece, double s) const {
    const SeenPlace left = seen_place(piece, s, Side::left), right = seen_place(piece, s, Side::right);
    const double square = constraints_.greatest_square(left.at_feed(range_.feed_factor));
    const double cube = square * std::sqrt(square);
    for (const base::Axis axis : base::all_axes) {
      const std::size_t i = base::index(axis);
      const double step = std::abs(right.jet[i].third - left.jet[i].third);
      if (step > 0 && step * cube > noticed_step * constraints_.of_axis(axis).jerk) return true;
    }
    return false;
  }

  bool jumps(std::size_t p) const {
    const toolpath::Piece &a = section_.piece(p), &b = section_.piece(p + 1);
    const geometry::PointJet leaving = one_sided_jets(a.axes(), a.axes().length(), Side::left);
    const geometry::PointJet entering = one_sided_jets(b.axes(), 0, Side::right);
    if (!a.is_fed_as(b)) return true;
    for (std::size_t i = 0; i < leaving.size(); ++i) {
      const double size = std::abs(leaving[i].third) + std::abs(entering[i].third);
      if (std::abs(leaving[i].third - entering[i].third) > 1e-6 * size) return true;
    }
    return false;
  }

  Sample at(double s, Side side) const {
    const bool is_of_tip = section_.piece(section_.piece_at(s, side)).transformation != nullptr;
    return sample_of(section_.see(s, side).at_feed(range_.feed_factor), s, from_rest(s), is_of_tip, constraints_);
  }

  double closest_per_ramp() const { return range_.closeness * per_ramp; }
  static double ramp_width(const Sample& sample, double x, double per) {
    return per_ramp / per * planner::ramp_width({infinity, sample.a, sample.j}, x);
  }
  double width_by_cap(const Sample& sample) const {
    const double d = from_rest(sample.s);
    return std::min(
        {ramp_width(sample, sample.cap, closest_per_ramp()), sample.h_curve, std::max(ramp_grading * d, 1e-12)});
  }

  /// Or so nearly that speed follows without effort: where feed is counted by some of the axes it may be asked to
  /// change all along a curve.
  static bool is_same(const Sample& a, const Sample& b) {
    const double change = std::abs(a.cap - b.cap);
    if (change <= 1e-9 * a.cap) return true;
    return a.is_by_feed && b.is_by_feed && change <= slow_change * std::min(a.cap, b.cap) &&
           change <= 2 * slow_tangent * std::min(a.a, b.a) * std::abs(a.s - b.s);
  }
  static double cruise_width(const Sample& sample, double x) {
    return std::max(ramp_width(sample, x, cruise_knots), cruise_time * std::sqrt(x));
  }
  /// Knots lie no wider here, whatever comes.
  static double widest(const Sample& sample) { return std::min(cruise_width(sample, sample.cap), sample.h_curve); }

  double first_knot() const { return range_.begin + knots_.start_ramp; }

  /// Samples between breaks, bisected until neighbours are no farther apart than twice the knots there; farther where
  /// the greatest speed is the same. From where they suffice for all knots that there may be, none.
  void sample() {
    const std::vector<double> breaks = breaks_;
    const std::vector<double>& kept = range_.kept;
    const double joint = kept.empty() ? first_knot() : kept.back();
    if (sample_from(kept.size() > kept_seen ? kept[kept.size() - 1 - kept_seen] : first_knot(), joint)) return;
    samples_.clear();
    breaks_ = breaks;
    sample_from(joint, joint);
  }

  /// Between two neighbours: no more than are placed there, whatever comes.
  double fewest_knots(const Sample& a, const Sample& b) const {
    const bool may_cruise = is_same(a, b);
    const auto width = [&](const Sample& sample) { return may_cruise ? widest(sample) : width_by_cap(sample); };
    return (b.s - a.s) / std::max(width(a), width(b));
  }

  /// False where there are too many before `joint`: what is kept may have far wider knots than would be placed there now.
  bool sample_from(double from, double joint) {
    constexpr double least_cuts = 8, most_widths = 32;  // of a cut
    const double most_sampled = sampled_beyond * static_cast<double>(most() + rest_knots - kept_);
    double before = 0, beyond = 0;
    for (std::size_t b = 0; b < breaks_.size(); ++b) {
      const double to = breaks_[b];
      if (!(to > from)) continue;
      samples_.push_back(at(from, Side::right));
      Sample previous = samples_.back();
      const double longest_cut = (to - from) / least_cuts;
      while (previous.s < to && effort_.spend(1)) {
        if (before > most_sampled) return false;
        if (beyond > most_sampled) {
          breaks_.resize(b);
          if (previous.s > from) breaks_.push_back(previous.s);
          ends_between_breaks_ = previous.s > from;
          reaches_end_ = false;
          return true;
        }
        const double cut = std::min(
            {longest_cut, most_widths * cruise_width(previous, previous.greatest), most_widths * previous.h_curve});
        // One at the joint: from there on knots lie as close as those before it.
        const double stop = previous.s < joint && joint < to ? joint : to;
        const bool is_last = previous.s + 1.001 * cut >= stop || previous.s + cut <= previous.s;
        const Sample next = at(is_last ? stop : previous.s + cut, Side::left);
        std::size_t i = samples_.size() - 1;
        bisect(previous, next, 0);
        samples_.push_back(next);
        for (; i + 1 < samples_.size(); ++i) {
          (samples_[i + 1].s > joint ? beyond : before) += fewest_knots(samples_[i], samples_[i + 1]);
        }
        previous = next;
      }
      from = to;
    }
    return true;
  }
  void bisect(const Sample& left, const Sample& right, int depth) {
    if (!effort_.spend(1)) return;
    const double width = right.s - left.s;
    const bool sees_all = section_.borders(left.s, right.s) <= most_between_samples;
    if (depth == deepest || (sees_all && width <= 2 * std::min(width_by_cap(left), width_by_cap(right)))) return;
    const Sample middle = at((left.s + right.s) / 2, Side::left);
    const bool is_cruise = middle.cap == middle.greatest && is_same(left, middle) && is_same(middle, right) &&
                           left.cap == left.greatest && right.cap == right.greatest;
    if (is_cruise && sees_all && width <= 2 * std::min(widest(left), widest(right))) return;
    bisect(left, middle, depth + 1);
    samples_.push_back(middle);
    bisect(middle, right, depth + 1);
  }

  void place_new() {
    passes();
    widths();
    if (range_.starts_at_rest) {
      knots_.s.push_back(first_knot());
      knots_.breaks.push_back(false);
    }
    distribute();
  }

  void passes() {
    const auto reach = [](Sample& to, const Sample& from) {
      to.reach = std::min(to.reach, from.reach + 2 * std::max(to.a, from.a) * std::abs(to.s - from.s));
    };
    for (std::size_t i = 1; i < samples_.size(); ++i) reach(samples_[i], samples_[i - 1]);
    for (std::size_t i = samples_.size() - 1; i-- > 0;) reach(samples_[i], samples_[i + 1]);
  }

  /// h at the samples. Far inside a cruise, where the greatest speed is the same for long, knots may lie wider.
  void widths() {
    std::vector<double> alone(samples_.size(), 0.0);  // distance to where the greatest speed changes
    // Where a cruise begins before the first sample, the knots that are kept there are as wide as it lets them be.
    if (samples_.front().s > first_knot()) alone[0] = infinity;
    const auto same = [](const Sample& a, const Sample& b) {
      return a.reach == a.cap && b.reach == b.cap && is_same(a, b);
    };
    for (std::size_t i = 1; i < samples_.size(); ++i) {
      if (same(samples_[i - 1], samples_[i])) alone[i] = alone[i - 1] + samples_[i].s - samples_[i - 1].s;
    }
    double behind = 0;
    for (std::size_t i = samples_.size(); i-- > 0;) {
      const bool joined = i + 1 < samples_.size() && same(samples_[i], samples_[i + 1]);
      behind = joined ? behind + samples_[i + 1].s - samples_[i].s : 0;
      alone[i] = std::min(alone[i], behind);
    }
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      Sample& sample = samples_[i];
      const double d = from_rest(sample.s);
      const double ramp = ramp_width(sample, sample.reach, closest_per_ramp());
      const double beyond = std::max(0.0, alone[i] - ramp * closest_per_ramp());
      const double cruise = std::min(cruise_width(sample, sample.reach), cruise_grading * beyond);
      sample.h = std::min({std::max(ramp, cruise), sample.h_curve, ramp_grading * d});
    }
    for (std::size_t i = 1; i < samples_.size(); ++i) {
      Sample &a = samples_[i - 1], &b = samples_[i];
      const double change = std::abs(a.cap - b.cap) / std::min(a.cap, b.cap);
      if (!(change > 1e-9) || !same(a, b)) continue;
      const double widest = change_of_knot / change * (b.s - a.s);
      for (Sample* const sample : {&a, &b})
        sample->h = std::min(sample->h, std::max(widest, ramp_width(*sample, sample->reach, closest_per_ramp())));
    }
    if (range_.kept.size() > 1) {  // what is new goes on from the last interval that is there
      const double joint = range_.kept.back(), width = joint - *(range_.kept.end() - 2);
      for (Sample& sample : samples_) {
        if (sample.s >= joint) sample.h = std::min(sample.h, width + grading * (sample.s - joint));
      }
    }
    double from = first_knot();
    std::size_t i = 0;
    for (const double to : breaks_) {  // no wider than the stretch between breaks
      if (!(to - from > merged_breaks * (i < samples_.size() ? samples_[i].h : 0))) continue;
      for (; i < samples_.size() && samples_[i].s <= to; ++i) samples_[i].h = std::min(samples_[i].h, to - from);
      from = to;
    }
    grade(samples_, grading);
  }

  /// What is kept, and between it knots that lie closer where the time law is another from `begin` on: there jerk
  /// changes at once.
  void keep() {
    const std::vector<double>& s = range_.kept;
    const machine::Derivatives limits = tangent_limits(section_.jets(range_.begin, Side::right), constraints_);
    const double first = first_change * planner::ramp_width(limits, range_.changes_from);
    double next = range_.changes_from > 0 ? s[0] + first : infinity;
    for (std::size_t k = 0; k < s.size(); ++k) {
      knots_.s.push_back(s[k]);
      knots_.breaks.push_back(range_.kept_breaks[k]);
      if (k + knots_at_end >= s.size()) continue;
      while (next < s[k + 1]) {
        const double width = first + change_grading * (next - s[0]);
        if (width > (s[k + 1] - s[k]) / 2) {
          next = infinity;
        } else {
          if (next - s[k] > width / 2 && s[k + 1] - next > width / 2) {
            knots_.s.push_back(next);
            knots_.breaks.push_back(false);
          }
          next += width;
        }
      }
    }
  }

  /// Equal quantiles of ∫ ds/h between breaks.
  void distribute() {
    double from = knots_.s.back();
    std::size_t i = 0;
    for (const double to : breaks_) {
      while (i + 1 < samples_.size() && samples_[i + 1].s <= from) ++i;
      if (!(to - from > merged_breaks * samples_[std::min(i, samples_.size() - 1)].h)) continue;
      i = place_quantiles(samples_, from, to, i, most_placed(), knots_);
      from = to;
      if (knots_.s.size() > most() + rest_knots) return;
    }
    // Where nothing more is known yet, it may be one.
    if (knots_.s.size() > kept_ && (ends_between_breaks_ || (range_.ends_at_rest && reaches_end_)))
      knots_.breaks.back() = false;
  }

  /// Ends in motion, where what is known beyond is enough to stop.
  void cut() {
    double longest = 0;
    for (const Sample& sample : samples_)
      longest = std::max(longest, per_ramp * ramp_width(sample, sample.greatest, per_ramp));
    // Nothing is unknown where motion is to rest.
    const double margin = range_.ends_at_rest ? 0 : std::min(unknown_margin * longest, 0.1 * length());
    if (knots_.s.size() < knots_beyond + 3) return;  // too little to go on with
    const std::size_t least = kept_ > knots_beyond + 1 ? kept_ - 1 : 1;
    std::size_t last = std::min(knots_.s.size() - 1 - knots_beyond, std::max(most(), least));
    // Nor may the last knot lie so near to where something unknown may begin that a tiny interval would follow.
    const auto too_near = [&](std::size_t k) {
      const double last_knot = knots_.s[k + knots_beyond], width = last_knot - knots_.s[k + knots_beyond - 1];
      return range_.end - knots_.s[k] < margin || range_.end - last_knot < width;
    };
    while (last > least && too_near(last)) --last;
    knots_.intervals = last;
    knots_.s.resize(last + 1 + knots_beyond);
    knots_.breaks.resize(last + 1 + knots_beyond);
    knots_.end_ramp = 0;
  }

  /// More than cut() looks at.
  std::size_t most_placed() const { return std::max(most(), kept_) + rest_knots + 1; }

  const Section& section_;
  const constraints::Constraints& constraints_;
  const PlannedRange& range_;
  std::size_t most_;
  Effort& effort_;
  std::size_t kept_ = 0;
  bool reaches_end_ = true;           ///< or is there more than knots may reach?
  bool ends_between_breaks_ = false;  ///< does what they may reach?
  std::vector<double> breaks_;
  std::vector<Sample> samples_;
  Knots knots_;
};

}  // namespace

machine::Derivatives tangent_limits(const geometry::PointJet& jet, const constraints::Constraints& constraints) {
  return constraints.along_tangent({jet, infinity});
}

double stop_time(double speed, const machine::Derivatives& limits) {
  const double a = limits.acceleration, j = limits.jerk;
  return speed > a * a / j ? speed / a + a / j : 2 * std::sqrt(speed / j);
}

double ramp_width(const machine::Derivatives& limits, double x) {
  const double speed = std::sqrt(x);
  return speed * stop_time(speed, limits) / per_ramp;
}

Knots place_knots(const Section& section, const constraints::Constraints& constraints, const PlannedRange& range,
                  std::size_t most, Effort& effort) {
  return Placement(section, constraints, range, most, effort).place();
}

}  // namespace leadscrew::planner
