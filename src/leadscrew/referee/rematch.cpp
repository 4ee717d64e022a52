#include <algorithm>
#include <cmath>
#include <leadscrew/referee/rematch.hpp>
#include <leadscrew/referee/tuning.hpp>

namespace leadscrew::referee {

namespace {

using namespace tuning::rematch;

bool is_nearer(const Candidate& a, const Candidate& b) {
  return is_better(a, b) || (!is_better(b, a) && a.distance < b.distance);
}

}  // namespace

Rematch::Cuts::Cuts(const Metric& metric, const Piece& piece) {
  if (!(piece.tolerance > 0)) return;
  const double parts = std::ceil(fineness * length_of(metric, piece) / piece.tolerance);
  const bool middle = parts > 2 * most_parts_at_end;
  count = middle ? 2 * most_parts_at_end + 1 : std::max(1, static_cast<int>(parts));
  fine = 1 / (middle ? parts : count);
}

double Rematch::Cuts::operator[](int i) const {
  return i <= count / 2 ? fine * i : 1 - fine * (count - i);
}

Rematch::Rematch(const Metric& metric, CandidateSet& whole, Cancellation& cancellation)
    : metric_(metric),
      cancellation_(cancellation),
      whole_(whole),
      parts_(metric, [this](Piece& part) { return next_part(part); }, cancellation) {}

void Rematch::set(Mark& mark) {
  mark.word = whole_.word();
  mark.words.clear();
  mark.candidates.clear();
  for (std::size_t i = 0; i <= whole_.last_alive(); ++i) {
    const CandidateSet::Slot& slot = whole_.slot(i);
    if (slot.now.alive) mark.candidates.push_back({whole_.front_serial() + static_cast<std::int64_t>(i), slot.now});
  }
}

void Rematch::start_recording() {
  set(older_);
  set(newer_);
  recording_ = true;
}

void Rematch::record(const Point& word, double allowance) {
  if (!recording_) return;
  std::vector<Word>& words = newer_.words;
  if (words.empty() || words.back().point != word) words.push_back({word, allowance});
}

void Rematch::advance_mark(double tolerance) {
  if (!recording_) return start_recording();
  if (near(newer_.word, tolerance) && newer_.words.size() < most_words) return;
  std::swap(older_, newer_);
  set(newer_);
}

void Rematch::stop() {
  recording_ = running_ = false;
}

void Rematch::stop_when_far(double tolerance) {
  if (!near(started_at_, tolerance)) running_ = false;
}

bool Rematch::near(const Point& place, double tolerance) const {
  return metric_.squared_distance(whole_.word(), place) <= far * far * tolerance * tolerance;
}

bool Rematch::begin_parts() {
  if (!recording_ || !whole_.keeps(first_needed())) return false;
  parts_.begin(older_.word);
  serial_ = first_needed();
  cut_ = 0;
  std::size_t i = 0;
  for (const Placed& placed : older_.candidates) {
    Candidate candidate = placed.candidate;
    while (true) {
      if (i == parts_.count() && !parts_.pull()) return false;
      const Piece& part = parts_.slot(i).piece;
      candidate.place = (placed.candidate.place - part.begins) / part.scale;
      if (part.serial == placed.serial && candidate.place <= part.span) break;
      ++i;
    }
    parts_.place(i, candidate);
  }
  return true;
}

bool Rematch::run() {
  if (!begin_parts()) return false;
  bool first = true;
  for (const Mark* mark : {&older_, &newer_}) {
    for (const Word& word : mark->words) {
      if (!first) parts_.adopt();
      first = false;
      if (!judge(word.point, word.allowance)) return false;
    }
  }
  if (first) return false;
  started_at_ = whole_.word();
  running_ = true;
  return true;
}

bool Rematch::observe(const Point& word, double allowance) {
  parts_.adopt();
  parts_.limit(most_parts);
  running_ = judge(word, allowance);
  return running_;
}

bool Rematch::judge(const Point& word, double allowance) {
  parts_.observe(word, allowance);
  best_ = parts_.step({nanometre, nanometre, most_parts});
  return !cancellation_.requested() && parts_.slot(best_).next.margin <= nanometre;
}

void Rematch::transfer_candidates() {
  std::size_t first = 0;
  while (!parts_.slot(first).next.alive) ++first;
  whole_.reach_back(parts_.slot(first).piece.serial);
  const auto index = [&](std::size_t part) {
    return static_cast<std::size_t>(parts_.slot(part).piece.serial - whole_.front_serial());
  };
  const std::size_t last = index(parts_.next_last());
  for (std::size_t i = 0; i <= last; ++i) whole_.slot(i).next = {};
  for (std::size_t i = first; i <= parts_.next_last(); ++i) {
    const Piece& part = parts_.slot(i).piece;
    const Candidate& candidate = parts_.slot(i).next;
    if (!candidate.alive) continue;
    CandidateSet::Slot& whole = whole_.slot(index(i));
    if (whole.next.alive && !is_nearer(candidate, whole.next)) continue;
    whole.next = candidate;
    whole.next.place = std::min(part.begins + part.scale * candidate.place, whole.piece.span);
    whole.next.held = true;  // the best of the parts need not be the nearest
  }
  whole_.replace_next(last);
}

std::optional<CandidateSet::End> Rematch::conclude() {
  if (!running_ && !run()) return std::nullopt;
  if (!whole_.keeps(serial_)) return std::nullopt;
  parts_.adopt();
  return parts_.conclude(0);
}

bool Rematch::next_part(Piece& result) {
  const Piece* piece = whole_.find(serial_);
  if (piece == nullptr) return false;
  if (cut_ == 0) cuts_ = parts_.count() < most_cut ? Cuts(metric_, *piece) : Cuts();
  result = cuts_.count == 1 ? *piece : part(metric_, *piece, piece->span * cuts_[cut_], piece->span * cuts_[cut_ + 1]);
  if (++cut_ == cuts_.count) {
    ++serial_;
    cut_ = 0;
  }
  return true;
}

}  // namespace leadscrew::referee
