#include <algorithm>
#include <leadscrew/referee/matcher.hpp>

namespace leadscrew::referee {

namespace {

constexpr std::size_t first_ring_size = 16;
constexpr std::size_t most_pieces = 16384;         // looked ahead while the trace follows the program
constexpr std::size_t most_pieces_departed = 256;  // and while it does not
constexpr double search_factor = 16;               // of the least cost, while it does not
constexpr double slack = 0.25;                     // of the tolerance: candidates that much beyond it are kept
constexpr double on_arc = 1e-3;                    // of the radius: words farther off may bend otherwise
constexpr double same_distance = 1e-9;             // mm; rounding is below
constexpr double greatest_stretch = 4. / 3;        // of a chord; an arc's of 2½ radians

}  // namespace

Matcher::Matcher(PieceSource& source, const Metric& metric)
    : source_(source), metric_(metric), slots_(first_ring_size) {}

bool Matcher::pull() {
  if (program_ended_) return false;
  if (count_ == slots_.size()) {
    std::vector<Slot> larger(2 * slots_.size());
    for (std::size_t i = 0; i < count_; ++i) larger[i] = slot(i);
    slots_ = std::move(larger);
    front_ = 0;
  }
  Slot& added = slot(count_);
  if (!source_.next(added.piece)) {
    program_ended_ = true;
    return false;
  }
  added.now.alive = false;
  ++count_;
  return true;
}

void Matcher::drop_front() {
  front_ = (front_ + 1) & (slots_.size() - 1);
  --count_;
}

Passage Matcher::begin(const Point& word) {
  word_ = word;
  chord_ = chord_between(metric_, word, word);
  if (!pull()) {
    Piece& point = slot(count_++).piece;  // a program that moves nothing: the path is where it stands
    point = {};
    point.from = point.to = source_.any_move() ? source_.start() : word;
    point.tolerance = source_.start_tolerance();
    point.feed.value = std::numeric_limits<double>::infinity();
  }
  Slot& first = slot(0);
  start_ = first.piece.from;
  end_ = first.piece.to;
  first.now = {};
  first.now.alive = true;
  first.now.cost = metric_.distance(word, start_);
  first.now.margin = first.now.cost - first.piece.tolerance;
  last_alive_ = 0;
  return follow();
}

Passage Matcher::observe(const Point& word, double excuse) {
  excuse_ = excuse;
  chord_ = chord_between(metric_, word_, word);
  word_ = word;
  return departed_ ? depart() : follow();
}

/// Path between two words departs from their chord by `distance`.
void Matcher::pass_over(double distance, double tolerance, base::Line line, Candidate& candidate) const {
  const double skip = std::max(0.0, distance - excuse_);
  const double margin = skip - tolerance;
  candidate.cost = std::max(candidate.cost, skip);
  candidate.margin = std::max(candidate.margin, margin);
  if (margin > candidate.skip_margin) {
    candidate.skip = skip;
    candidate.skip_margin = margin;
    candidate.skip_line = line;
  }
}

/// The arc or curve from the candidate's place to another, `distance` from the chord, was passed over between two
/// words.
void Matcher::pass_bend(const Piece& piece, double to, double distance, Candidate& candidate) const {
  const double from = candidate.place;
  if (!(to > from)) return;
  const double enough =
      excuse_ + std::min(std::max(0.0, candidate.cost), std::max(0.0, candidate.margin + piece.tolerance));
  const double farthest =
      farthest_from_chord(metric_, piece, from, to, chord_, std::max(candidate.distance, distance), enough);
  if (farthest > enough) pass_over(farthest, piece.tolerance, piece.line, candidate);
}

/// The better of the piece's own candidate and of the one that comes from before it, taken to the word.
Matcher::Candidate Matcher::candidate_on(const Slot& slot, const Candidate& carried) {
  const Piece& piece = slot.piece;
  const Nearest nearest = nearest_on(metric_, piece, word_);
  const auto arrive = [&](Candidate candidate, double place, double distance) {
    if (piece.kind != Piece::Kind::line) pass_bend(piece, place, distance, candidate);
    candidate.place = place;
    candidate.distance = distance;
    candidate.cost = std::max(candidate.cost, distance);
    candidate.margin = std::max(candidate.margin, distance - piece.tolerance);
    return candidate;
  };
  Candidate best;
  if (carried.alive) best = arrive(carried, nearest.place, nearest.distance);
  if (slot.now.alive) {
    const bool onward = nearest.place >= slot.now.place;
    const double place = onward ? nearest.place : slot.now.place;
    const double distance = onward ? nearest.distance : metric_.distance(word_, point_at(metric_, piece, place));
    const Candidate own = arrive(slot.now, place, distance);
    if (!best.alive || own.margin < best.margin) best = own;
  }
  return best;
}

/// The better of the piece's own candidate and of the one that comes from before it, as they are when the rest of the
/// piece's bend, its end `distance` from the chord, has been passed over: more of it by the one from before.
Matcher::Candidate Matcher::past_bend(const Slot& slot, double distance, const Candidate& carried) const {
  const Piece& piece = slot.piece;
  const auto pass = [&](Candidate candidate) {
    if (piece.kind != Piece::Kind::line) pass_bend(piece, piece.span, distance, candidate);
    return candidate;
  };
  if (!slot.now.alive) return pass(carried);
  const Candidate own = pass(slot.now);
  if (!carried.alive) return own;
  const Candidate before = pass(carried);
  return own.margin < before.margin ? own : before;
}

/// Takes the better of the candidate from before piece i and of its own past the end of the piece; it dies of a margin
/// beyond `most`.
void Matcher::pass_to_end(std::size_t i, double most, Candidate& candidate) {
  const Slot& here = slot(i);
  const Piece& piece = here.piece;
  const double tolerance = i + 1 < count_ ? std::max(piece.tolerance, slot(i + 1).piece.tolerance) : piece.tolerance;
  const double distance = distance_to_chord(metric_, chord_, piece.to);
  if (distance - excuse_ - tolerance > most) {
    candidate.alive = false;
    return;
  }
  candidate = past_bend(here, distance, candidate);
  pass_over(distance, tolerance, piece.line, candidate);
  candidate.place = 0;
  candidate.distance = distance;
  candidate.alive = candidate.margin <= most;
}

/// Computes every candidate after the chord; returns the slot of the best.
std::size_t Matcher::step(const Reach& reach) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  Candidate carried;
  next_alive_ = 0;
  next_last_ = 0;
  stepped_ = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    if (i > last_alive_ && !carried.alive) break;
    Slot& here = slot(i);
    stepped_ = i + 1;
    here.next.alive = false;
    if (!carried.alive && !here.now.alive) continue;
    here.next = candidate_on(here, carried);
    if (here.next.margin < least) {
      least = here.next.margin;
      best = i;
    }
    here.next.alive = here.next.margin <= reach.keep + slack * here.piece.tolerance;
    if (here.next.alive) {
      ++next_alive_;
      next_last_ = i;
    }
    const double nearest_carry = std::min(here.now.alive ? here.now.margin : std::numeric_limits<double>::infinity(),
                                          carried.alive ? carried.margin : std::numeric_limits<double>::infinity());
    const double most = reach.carry + slack * here.piece.tolerance;
    if (nearest_carry > most) {
      carried.alive = false;
      continue;
    }
    if (i + 1 == count_ && count_ < reach.pieces) pull();
    pass_to_end(i, most, carried);
  }
  return best;
}

/// Makes the step's candidates the present ones.
void Matcher::adopt() {
  for (std::size_t i = 0; i < stepped_; ++i) slot(i).now = slot(i).next;
  std::size_t dead = 0;
  while (dead < next_last_ && !slot(dead).now.alive) ++dead;
  for (std::size_t i = 0; i < dead; ++i) drop_front();
  last_alive_ = next_last_ - dead;
}

Passage Matcher::follow() {
  const std::size_t best = step({nanometre, nanometre, most_pieces});
  if (slot(best).next.margin > nanometre) {
    least_margin_ = slot(best).next.margin;
    return depart();
  }
  Passage result = passage(next_last_);
  adopt();
  if (next_alive_ == 1) {
    Candidate& only = slot(0).now;
    deviation_ = std::max(deviation_, only.cost);
    only.cost = 0;
    only.margin = none;
  } else if (count_ == most_pieces) {
    drop_front();
    --last_alive_;
  }
  return result;
}

/// The best candidate ahead of the trace's departure, or the return to the path.
Passage Matcher::depart() {
  std::size_t best = step({least_margin_, search_factor * least_margin_, most_pieces_departed});
  double least = slot(best).next.margin;
  if (!departed_ || least > least_margin_) {
    best = step({search_factor * least, search_factor * least, most_pieces_departed});
    least = slot(best).next.margin;
  }
  departed_ = true;
  least_margin_ = least;
  const Slot& chosen = slot(best);
  const bool on_path = chosen.next.distance - chosen.piece.tolerance <= nanometre;
  Passage result = passage(best);
  if (!on_path) {
    // At a corner the block that is not followed is the one that begins there.
    const bool at_corner = best + 1 < stepped_ && slot(best + 1).next.alive &&
                           slot(best + 1).next.distance <= chosen.next.distance + same_distance;
    const base::Line line = slot(at_corner ? best + 1 : best).piece.line;
    result.deviation = Finding{line, chosen.next.distance, chosen.piece.tolerance};
    for (std::size_t i = 0; i < best; ++i) slot(i).next.alive = false;
    adopt();
    return result;
  }
  settle(best, result);
  return result;
}

/// The trace is on the path again: its departure is judged, and candidates as good as the best start afresh.
void Matcher::settle(std::size_t best, Passage& result) {
  const Candidate winner = slot(best).next;
  deviation_ = std::max(deviation_, winner.cost);
  if (winner.skip_margin > nanometre) {
    result.skipped = Finding{winner.skip_line, winner.skip, winner.skip - winner.skip_margin};
  }
  next_last_ = best;
  for (std::size_t i = 0; i < stepped_; ++i) {
    Slot& here = slot(i);
    Candidate& next = here.next;
    next.alive =
        next.alive && next.margin <= winner.margin + nanometre && next.distance - here.piece.tolerance <= nanometre;
    if (!next.alive) continue;
    next_last_ = i;
    next.cost = next.distance;
    next.margin = next.distance - here.piece.tolerance;
    next.skip = 0;
    next.skip_margin = none;
  }
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
    one_block = one_block && here.piece.block == slot(0).piece.block;
    if (here.next.alive && here.next.distance < distance - same_distance) {
      distance = here.next.distance;
      nearest = i;
    }
  }
  const Slot& matched = slot(nearest);
  result.line = matched.piece.line;
  const double place = matched.piece.angle_before + matched.next.place;
  if (one_block && matched.piece.block == matched_.block) {
    const double off = std::max(matched.next.distance, matched_.distance);
    if (matched.piece.kind == Piece::Kind::arc && off <= nanometre + on_arc * matched.piece.radius) {
      result.arc = &matched.piece;
      result.turn = std::abs(place - matched_.place);
    } else if (matched.piece.kind == Piece::Kind::curve && std::isfinite(result.feed.value)) {
      result.stretch = stretch_to(nearest);
    }
  }
  matched_ = {matched.piece.block, matched.piece.number, place, matched.next.distance};
  return result;
}

/// Length of a curve from the match of the word before to this word's over the length of their chord, in the axes of
/// the feed; 1 where a word does not lie on it, or where the chord says too little.
double Matcher::stretch_to(std::size_t nearest) {
  const Slot& end = slot(nearest);
  const std::int64_t behind = end.piece.number - matched_.number;
  if (behind < 0 || behind > static_cast<std::int64_t>(nearest)) return 1;
  if (std::max(end.next.distance, matched_.distance) > nanometre) return 1;
  const std::size_t begin = nearest - static_cast<std::size_t>(behind);
  if (behind == 0 && !(end.next.place > matched_.place)) return 1;
  const Coordinates coordinates = coordinates_of(metric_, end.piece.feed.axes);
  double length = 0;
  for (std::size_t i = begin; i <= nearest; ++i) {
    const double from = i == begin ? matched_.place : 0, to = i == nearest ? end.next.place : 1;
    length += length_in(metric_, coordinates, part(metric_, slot(i).piece.segment, from, to));
  }
  const double chord = distance_in(metric_, coordinates, point_at(metric_, slot(begin).piece, matched_.place),
                                   point_at(metric_, end.piece, end.next.place));
  return length > chord && length <= greatest_stretch * chord ? length / chord : 1;
}

std::optional<Finding> Matcher::conclude() {
  chord_ = chord_between(metric_, word_, word_);
  excuse_ = 0;
  Candidate carried;
  Candidate before_end;
  while (count_ > 0) {
    if (count_ == 1) pull();
    const Slot& here = slot(0);
    end_ = here.piece.to;
    before_end = past_bend(here, metric_.distance(word_, end_), carried);
    pass_to_end(0, std::numeric_limits<double>::infinity(), carried);
    drop_front();
  }
  deviation_ = std::max(deviation_, carried.cost);
  if (before_end.skip_margin > nanometre) {
    return Finding{before_end.skip_line, before_end.skip, before_end.skip - before_end.skip_margin};
  }
  return std::nullopt;
}

}  // namespace leadscrew::referee
