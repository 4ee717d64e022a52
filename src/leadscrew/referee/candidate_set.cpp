#include <algorithm>
#include <leadscrew/referee/candidate_set.hpp>
#include <leadscrew/referee/tuning.hpp>

namespace leadscrew::referee {

namespace {

constexpr std::size_t first_ring_size = 16;

}  // namespace

CandidateSet::CandidateSet(const Metric& metric, Supply supply, Cancellation& cancellation)
    : metric_(metric), supply_(std::move(supply)), cancellation_(cancellation), slots_(first_ring_size) {}

bool CandidateSet::pull() {
  if (program_ended_) return false;
  if (kept_ + count_ == slots_.size()) {
    std::vector<Slot> larger(2 * slots_.size());
    for (std::size_t i = 0; i < kept_ + count_; ++i) larger[i] = std::move(slot(i - kept_));
    slots_ = std::move(larger);
    front_ = kept_;
  }
  Slot& added = slot(count_);
  if (!supply_(added.piece)) {
    program_ended_ = true;
    return false;
  }
  added.now.alive = false;
  ++count_;
  return true;
}

void CandidateSet::drop_front() {
  front_ = (front_ + 1) & (slots_.size() - 1);
  --count_;
  ++kept_;
  ++front_serial_;
}

Piece& CandidateSet::add_point() {
  Slot& added = slot(count_++);
  added.now.alive = false;
  return added.piece = {};
}

bool CandidateSet::keeps(std::int64_t serial) const {
  return serial >= front_serial_ - static_cast<std::int64_t>(kept_);
}

void CandidateSet::keep_from(std::int64_t serial) {
  const std::int64_t behind = std::max<std::int64_t>(0, front_serial_ - serial);
  kept_ = std::min(kept_, static_cast<std::size_t>(behind));
}

const Piece* CandidateSet::find(std::int64_t serial) {
  if (!keeps(serial)) return nullptr;
  while (serial >= front_serial_ + static_cast<std::int64_t>(count_)) {
    if (!pull()) return nullptr;
  }
  return &slot(static_cast<std::size_t>(serial - front_serial_)).piece;
}

void CandidateSet::reach_back(std::int64_t serial) {
  for (; front_serial_ > serial; --front_serial_, ++count_, --kept_) {
    front_ = (front_ - 1) & (slots_.size() - 1);
    slot(0).now.alive = false;
    ++last_alive_;
  }
}

void CandidateSet::begin(const Point& word) {
  front_ = count_ = kept_ = 0;
  program_ended_ = false;
  last_alive_ = 0;
  word_ = word;
  allowance_ = 0;
  chord_ = chord_between(metric_, word, word);
}

void CandidateSet::observe(const Point& word, double allowance) {
  allowance_ = allowance;
  chord_ = chord_between(metric_, word_, word);
  word_ = word;
}

void CandidateSet::place(std::size_t i, const Candidate& candidate) {
  slot(i).now = candidate;
  last_alive_ = i;
}

/// Path between two words departs from their chord by `distance`.
void CandidateSet::pass_over(double distance, double tolerance, base::Line line, Candidate& candidate) const {
  const double skip = std::max(0.0, distance - allowance_);
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
void CandidateSet::pass_bend(const Piece& piece, double to, double distance, Candidate& candidate) const {
  const double from = candidate.place;
  if (!(to > from)) return;
  const double negligible =
      allowance_ + std::min(std::max(0.0, candidate.cost), std::max(0.0, candidate.margin + piece.tolerance));
  const double farthest =
      farthest_from_chord(metric_, piece, from, to, chord_, std::max(candidate.distance, distance), negligible);
  if (farthest > negligible) pass_over(farthest, piece.tolerance, piece.line, candidate);
}

/// The better of the piece's own candidate and of the one that comes from before it, taken to the word.
Candidate CandidateSet::candidate_on(const Slot& slot, const Candidate& carried) {
  const Piece& piece = slot.piece;
  const Nearest nearest = nearest_on(metric_, piece, word_);
  const auto arrive = [&](Candidate candidate, double place, double distance) {
    if (piece.kind != Piece::Kind::line) pass_bend(piece, place, distance, candidate);
    candidate.place = place;
    candidate.held = place > nearest.place;
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
    if (!best.alive || is_better(own, best)) best = own;
  }
  return best;
}

/// The better of the piece's own candidate and of the one that comes from before it, as they are when the rest of the
/// piece's bend, its end `distance` from the chord, has been passed over: more of it by the one from before.
Candidate CandidateSet::past_bend(const Slot& slot, double distance, const Candidate& carried) const {
  const Piece& piece = slot.piece;
  const auto pass = [&](Candidate candidate) {
    if (piece.kind != Piece::Kind::line) pass_bend(piece, piece.span, distance, candidate);
    return candidate;
  };
  if (!slot.now.alive) return pass(carried);
  const Candidate own = pass(slot.now);
  if (!carried.alive) return own;
  const Candidate before = pass(carried);
  return is_better(own, before) ? own : before;
}

/// Takes the better of the candidate from before piece i and of its own past the end of the piece; it dies of a margin
/// beyond `most`.
void CandidateSet::pass_to_end(std::size_t i, double most, Candidate& candidate) {
  const Slot& here = slot(i);
  const Piece& piece = here.piece;
  // Where two blocks meet, each of them asks for its own tolerance.
  const bool next_asks_more = i + 1 < count_ && slot(i + 1).piece.tolerance < piece.tolerance;
  const Piece& asking = next_asks_more ? slot(i + 1).piece : piece;
  const double distance = distance_to_chord(metric_, chord_, piece.to);
  if (distance - allowance_ - asking.tolerance > most) {
    candidate.alive = false;
    return;
  }
  candidate = past_bend(here, distance, candidate);
  pass_over(distance, asking.tolerance, asking.line, candidate);
  candidate.place = 0;
  candidate.held = false;
  candidate.distance = distance;
  candidate.alive = candidate.margin <= most;
}

std::size_t CandidateSet::step(const Reach& reach) {
  std::size_t best = 0;
  Candidate least, carried;
  least.margin = std::numeric_limits<double>::infinity();
  next_alive_ = 0;
  next_last_ = 0;
  stepped_ = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    if ((i > last_alive_ && !carried.alive) || cancellation_.asked()) break;
    Slot& here = slot(i);
    stepped_ = i + 1;
    here.next.alive = false;
    if (!carried.alive && !here.now.alive) continue;
    here.next = candidate_on(here, carried);
    if (is_better(here.next, least)) {
      least = here.next;
      best = i;
    }
    here.next.alive = here.next.margin <= reach.keep + tuning::candidates::slack * here.piece.tolerance;
    if (here.next.alive) {
      ++next_alive_;
      next_last_ = i;
    }
    const double nearest_carry = std::min(here.now.alive ? here.now.margin : std::numeric_limits<double>::infinity(),
                                          carried.alive ? carried.margin : std::numeric_limits<double>::infinity());
    const double most = reach.carry + tuning::candidates::slack * here.piece.tolerance;
    if (nearest_carry > most) {
      carried.alive = false;
      continue;
    }
    if (i + 1 == count_ && count_ < reach.pieces) pull();
    pass_to_end(i, most, carried);
  }
  return best;
}

bool CandidateSet::leads_on(const Point& word, double allowance, const Reach& reach) {
  const Point before = word_;
  observe(word, allowance);
  step(reach);
  bool leads = false;
  for (std::size_t i = 0; i < stepped_ && !leads; ++i) {
    const Slot& here = slot(i);
    leads = here.next.alive && here.next.distance - here.piece.tolerance <= reach.carry &&
            (!here.now.alive || here.next.place > here.now.place);
  }
  word_ = before;
  return leads;
}

void CandidateSet::adopt() {
  for (std::size_t i = 0; i < stepped_; ++i) slot(i).now = slot(i).next;
  std::size_t dead = 0;
  while (dead < next_last_ && !slot(dead).now.alive) ++dead;
  for (std::size_t i = 0; i < dead; ++i) drop_front();
  last_alive_ = next_last_ - dead;
}

void CandidateSet::limit(std::size_t pieces) {
  if (count_ < pieces || last_alive_ == 0) return;
  drop_front();
  --last_alive_;
}

void CandidateSet::replace_next(std::size_t last) {
  stepped_ = std::max(last, last_alive_) + 1;
  next_alive_ = 0;
  next_last_ = last;
  for (std::size_t i = 0; i < stepped_; ++i) {
    if (i > last) slot(i).next.alive = false;
    if (slot(i).next.alive) ++next_alive_;
  }
}

CandidateSet::End CandidateSet::conclude(std::size_t most_kept) {
  chord_ = chord_between(metric_, word_, word_);
  allowance_ = 0;
  End end;
  while (count_ > 0 && !cancellation_.asked()) {
    if (count_ == 1) pull();
    const Slot& here = slot(0);
    end.point = here.piece.to;
    end.before = past_bend(here, metric_.distance(word_, end.point), end.at);
    pass_to_end(0, std::numeric_limits<double>::infinity(), end.at);
    drop_front();
    if (kept_ > most_kept) kept_ = 0;
  }
  return end;
}

}  // namespace leadscrew::referee
