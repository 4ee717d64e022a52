#include <algorithm>
#include <leadscrew/referee/matcher.hpp>
#include <leadscrew/referee/tuning.hpp>

namespace leadscrew::referee {

namespace {

using namespace tuning::matching;

constexpr double on_arc = 1e-3;         // of the radius: words farther off may bend otherwise
constexpr double same_distance = 1e-9;  // mm; rounding is below

}  // namespace

Matcher::Matcher(PieceSource& source, const Metric& metric, Cancellation& cancellation, bool tells_places)
    : source_(source),
      metric_(metric),
      tells_places_(tells_places),
      candidates_(
          metric, [&source](Piece& piece) { return source.next(piece); }, cancellation),
      rematch_(metric, candidates_, cancellation),
      curve_travel_(metric) {}

Passage Matcher::begin(const Point& word) {
  candidates_.begin(word);
  if (!candidates_.pull()) {
    Piece& point = candidates_.add_point();  // a program that moves nothing: the path is where it stands
    point.from = point.to = source_.any_move() ? source_.start() : word;
    point.tolerance = source_.start_tolerance();
    point.feed.value = std::numeric_limits<double>::infinity();
  }
  const Piece& first = slot(0).piece;
  start_ = first.from;
  end_ = first.to;
  Candidate candidate;
  candidate.alive = true;
  candidate.cost = metric_.distance(word, start_);
  candidate.margin = candidate.cost - first.tolerance;
  candidates_.place(0, candidate);
  rematch_.start_recording();
  return follow(0);
}

Passage Matcher::observe(const Point& word, double allowance) {
  candidates_.observe(word, allowance);
  return departed_ ? depart() : follow(allowance);
}

/// Whether the best match is beyond the tolerance, or farther than any has been for certain.
bool Matcher::needs_rematch(double cost, double margin, double tolerance) const {
  return margin > nanometre || cost > confirmed_ + std::max(nanometre, tuning::rematch::step * tolerance);
}

Passage Matcher::follow(double allowance) {
  rematch_.record(candidates_.word(), allowance);
  bool rematched = rematch_.running() && rematch_.observe(candidates_.word(), allowance);
  if (!rematched) {
    const Slot& best = slot(candidates_.step({nanometre, nanometre, most_pieces}));
    if (needs_rematch(best.next.cost, best.next.margin, best.piece.tolerance)) {
      rematched = rematch_.run();
      if (!rematched && best.next.margin > nanometre) {
        least_margin_ = best.next.margin;
        return depart();
      }
      if (!rematched) confirmed_ = best.next.cost;
    }
  }
  if (rematched) {
    confirmed_ = std::max(confirmed_, rematch_.least_cost());
    rematch_.transfer_candidates();
  }
  Passage result = passage(candidates_.next_last());
  adopt();
  if (candidates_.next_alive() == 1 && !rematch_.running()) {
    Candidate& only = slot(0).now;
    deviation_ = std::max(deviation_, only.cost);
    only.reset_cost();
  } else {
    candidates_.limit(most_pieces);
  }
  const double tolerance = source_.largest_tolerance();
  if (rematch_.running()) rematch_.stop_when_far(tolerance);
  if (tolerance > 0) rematch_.advance_mark(tolerance);
  return result;
}

/// Makes the step's candidates the present ones.
void Matcher::adopt() {
  candidates_.adopt();
  candidates_.keep_from(rematch_.recording() ? rematch_.first_needed() : std::numeric_limits<std::int64_t>::max());
}

/// At a corner the block that is not followed is the one that begins there: is the word as near to it, and too far? Its
/// tolerance may be so small that the matching has not come to it.
bool Matcher::leaves_the_next(std::size_t best) {
  if (best + 1 >= candidates_.count()) return false;
  const Slot &chosen = slot(best), &next = slot(best + 1);
  const bool is_reached = best + 1 < candidates_.stepped() && next.next.alive;
  if (!is_reached && chosen.next.place < chosen.piece.span) return false;
  const double distance =
      is_reached ? next.next.distance : nearest_on(metric_, next.piece, candidates_.word()).distance;
  return distance <= chosen.next.distance + same_distance && distance > next.piece.tolerance + nanometre;
}

/// The best candidate ahead of the trace's departure, or the return to the path.
Passage Matcher::depart() {
  rematch_.stop();
  std::size_t best = candidates_.step({least_margin_, search_factor * least_margin_, most_pieces_departed});
  double least = slot(best).next.margin;
  if (!departed_ || least > least_margin_) {
    best = candidates_.step({search_factor * least, search_factor * least, most_pieces_departed});
    least = slot(best).next.margin;
  }
  departed_ = true;
  least_margin_ = least;
  const Slot& chosen = slot(best);
  const bool on_path = chosen.next.distance - chosen.piece.tolerance <= nanometre;
  Passage result = passage(best);
  if (!on_path) {
    const Piece& left = slot(leaves_the_next(best) ? best + 1 : best).piece;
    result.deviation = Finding{left.line, chosen.next.distance, left.tolerance};
    for (std::size_t i = 0; i < best; ++i) slot(i).next.alive = false;
    adopt();
    return result;
  }
  rejoin(best, result);
  return result;
}

/// The trace is on the path again: its departure is judged, and candidates as good as the best start afresh.
void Matcher::rejoin(std::size_t best, Passage& result) {
  const Candidate winner = slot(best).next;
  deviation_ = std::max(deviation_, winner.cost);
  if (winner.skip_margin > nanometre) {
    result.skipped = Finding{winner.skip_line, winner.skip, winner.skip - winner.skip_margin};
  }
  std::size_t last = best;
  for (std::size_t i = 0; i < candidates_.stepped(); ++i) {
    Slot& here = slot(i);
    Candidate& next = here.next;
    next.alive =
        next.alive && next.margin <= winner.margin + nanometre && next.distance - here.piece.tolerance <= nanometre;
    if (!next.alive) continue;
    last = i;
    next.cost = next.distance;
    next.margin = next.distance - here.piece.tolerance;
    next.skip = 0;
    next.skip_margin = Candidate::none;
  }
  candidates_.replace_next(last);
  confirmed_ = std::max(confirmed_, deviation_);
  departed_ = false;
  adopt();
}

/// What lies between the word before, which may lie on any piece from the first, and this one, which may lie on any to
/// `last`.
Passage Matcher::passage(std::size_t last) {
  Passage result;
  result.feed = slot(0).piece.feed;
  std::size_t nearest = last;
  double distance = std::numeric_limits<double>::infinity();
  bool one_block = true;
  for (std::size_t i = 0; i <= last; ++i) {
    const Slot& here = slot(i);
    const ProgrammedFeed& feed = here.piece.feed;
    result.feed.value = feed.axes == result.feed.axes ? std::max(result.feed.value, feed.value)
                                                      : std::numeric_limits<double>::infinity();
    result.feed.is_of_contact = result.feed.is_of_contact || feed.is_of_contact;
    one_block = one_block && here.piece.block == slot(0).piece.block;
    if (here.next.alive && here.next.distance < distance - same_distance) {
      distance = here.next.distance;
      nearest = i;
    }
  }
  const Slot& matched = slot(nearest);
  result.line = matched.piece.line;
  result.block_feed = matched.piece.feed.value;
  result.tool = matched.piece.tool;
  result.distance = matched.next.distance;
  result.tolerance = matched.piece.tolerance;
  result.orientation_tolerance = matched.piece.orientation_tolerance;
  if (tells_places_) result.place = point_at(metric_, matched.piece, matched.next.place);
  const bool stays = one_block && matched.piece.block == matched_.block;
  const double angle = matched.piece.angle_before + matched.next.place;
  if (stays && matched.piece.kind == Piece::Kind::arc &&
      std::max(matched.next.distance, matched_.distance) <= nanometre + on_arc * matched.piece.radius) {
    result.arc = &matched.piece;
    result.turn = std::abs(angle - matched_.angle);
  }
  if (!stays) curve_travel_.forget();
  if (matched.piece.kind == Piece::Kind::curve) result.stretch = curve_travel_.observe(candidates_, last);
  matched_ = {matched.piece.block, angle, matched.next.distance};
  return result;
}

bool Matcher::is_at_end(double reach) {
  const std::size_t last = candidates_.last_alive();
  if (last + 1 == candidates_.count() && candidates_.pull()) return false;
  const Slot& here = slot(last);
  return last + 1 == candidates_.count() && here.now.alive &&
         metric_.distance(candidates_.word(), here.piece.to) <= reach;
}

bool Matcher::leads_on(const Point& word, double allowance) {
  const double margin = departure() + nanometre;
  return candidates_.leads_on(word, allowance, {margin, margin, most_pieces_departed});
}

std::optional<Finding> Matcher::conclude() {
  const double tolerance = source_.end_tolerance();
  CandidateSet::End end = candidates_.conclude(most_pieces);
  end_ = end.point;
  if (rematch_.running() || needs_rematch(end.at.cost, end.at.margin, tolerance)) {
    const std::optional<CandidateSet::End> rematched = rematch_.conclude();
    if (rematched && is_better(rematched->at, end.at)) end = *rematched;
  }
  deviation_ = std::max(deviation_, end.at.cost);
  const Candidate& last = end.before;
  if (last.skip_margin > nanometre) return Finding{last.skip_line, last.skip, last.skip - last.skip_margin};
  return std::nullopt;
}

}  // namespace leadscrew::referee
