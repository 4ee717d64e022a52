#pragma once
// The candidate set: every place of the path that the latest word may be matched to, carried from word to word
// (matcher.hpp).
//
// Every piece of the path holds at most one candidate: the place on this piece that is matched to the latest word, and
// the largest distance of the matching that leads to it. From word to word,
//
//     cost'(piece) = max(distance of the word to the piece, min(cost(piece), carried)),
//     carried      = min over earlier pieces of max(cost, largest distance of all between to the chord − allowance),
//
// with the sampling allowance a·T²/8 (sampling_allowance.hpp). On its piece a candidate goes to the place nearest to
// the word and never back. Where words run back along a piece its distance therefore comes out too large, by no more
// than the piece's length: a matching that visits the same pieces in the same order has every word on the same piece.

#include <algorithm>
#include <cstdint>
#include <functional>
#include <leadscrew/base/line.hpp>
#include <leadscrew/referee/cancellation.hpp>
#include <leadscrew/referee/piece.hpp>
#include <limits>
#include <vector>

namespace leadscrew::referee {

/// A possible match. Margins are distances less the tolerance at their place.
struct Candidate {
  static constexpr double none = -std::numeric_limits<double>::infinity();

  bool alive = false;
  double place = 0;           ///< on its piece
  bool held = false;          ///< true if a place before it on the piece, to which it may not return, may be nearer
  double distance = 0;        ///< mm; from there to the latest word, or to the chord where path was passed over
  double cost = 0;            ///< mm; largest distance since the last reset_cost()
  double margin = none;       ///< mm; largest margin since then
  double skip = 0;            ///< mm; largest distance of path between words to their chord, less the allowance
  double skip_margin = none;  ///< mm
  base::Line skip_line{};

  /// Where this is the only candidate left, its past no longer decides between matchings.
  void reset_cost() {
    cost = 0;
    margin = none;
  }
};

/// Inside the tolerances all matchings are as good, and the one that lies nearest tells the deviation; where tolerances
/// differ, that need not be the one that lies farthest inside.
inline bool is_better(const Candidate& a, const Candidate& b) {
  const double outside_a = std::max(0.0, a.margin), outside_b = std::max(0.0, b.margin);
  return outside_a < outside_b || (outside_a == outside_b && a.cost < b.cost);
}

class CandidateSet {
 public:
  /// The next piece; false at the program's end.
  using Supply = std::function<bool(Piece&)>;

  struct Slot {
    Piece piece;
    Candidate now;
    Candidate next;
  };

  /// How far candidates may go in one step; a quarter of the tolerance is added to both margins.
  struct Reach {
    double carry = nanometre;  ///< mm; margin up to which path is passed over
    double keep = nanometre;   ///< mm; margin up to which a candidate is kept
    std::size_t pieces = 0;    ///< ahead
  };

  CandidateSet(const Metric& metric, Supply supply, Cancellation& cancellation);

  /// Drops all pieces and candidates and takes this as the latest word.
  void begin(const Point& word);
  /// The next word; `allowance`: how far the motion may have been from the chord to it, mm.
  void observe(const Point& word, double allowance);

  /// Computes every `next` after the chord; returns the slot of the best. Of no use once cancelled, as conclude() is.
  std::size_t step(const Reach& reach);
  /// Would this word, the next one, be within the tolerance of the path and farther along it than the word before? Computes
  /// every `next`, as step() does.
  bool leads_on(const Point& word, double allowance, const Reach& reach);
  /// Makes every `next` the present candidate and drops the pieces before the first candidate.
  void adopt();
  /// Drops the first piece if as many as `pieces` are held.
  void limit(std::size_t pieces);

  /// The best candidate at the end of the program after the last word, and what it was before the end point itself was
  /// passed over.
  struct End {
    Candidate at, before;
    Point point{};
  };
  End conclude(std::size_t most_kept);

  bool pull();
  void drop_front();
  /// Adds a piece without length, for a program that has none.
  Piece& add_point();

  Slot& slot(std::size_t i) { return slots_[(front_ + i) & (slots_.size() - 1)]; }
  std::size_t count() const { return count_; }
  std::size_t stepped() const { return stepped_; }
  std::size_t last_alive() const { return last_alive_; }  ///< slot of the last candidate
  std::size_t next_alive() const { return next_alive_; }  ///< number of `next` alive
  std::size_t next_last() const { return next_last_; }    ///< slot of the last of them
  const Point& word() const { return word_; }

  /// Puts a candidate on a slot; slots in rising order.
  void place(std::size_t i, const Candidate& candidate);
  /// Takes `next` of the slots up to `last`, as the caller has set them, for the result of the step.
  void replace_next(std::size_t last);

  /// Of the dropped pieces, keeps those from this serial number on; find() and reach_back() still know them.
  void keep_from(std::int64_t serial);
  bool keeps(std::int64_t serial) const;
  std::int64_t front_serial() const { return front_serial_; }
  const Piece* find(std::int64_t serial);
  /// Takes kept pieces from this one on back to the front, without candidates.
  void reach_back(std::int64_t serial);

 private:
  Candidate candidate_on(const Slot& slot, const Candidate& carried);
  Candidate past_bend(const Slot& slot, double distance, const Candidate& carried) const;
  void pass_to_end(std::size_t i, double most, Candidate& candidate);
  void pass_bend(const Piece& piece, double to, double distance, Candidate& candidate) const;
  void pass_over(double distance, double tolerance, base::Line line, Candidate& candidate) const;

  const Metric& metric_;
  Supply supply_;
  Cancellation& cancellation_;
  double allowance_ = 0;
  Chord chord_;
  Point word_{};

  std::vector<Slot> slots_;  // a ring; its size is a power of two
  std::size_t front_ = 0, count_ = 0;
  std::size_t kept_ = 0;           // slots before the front
  std::int64_t front_serial_ = 0;  // of the piece at the front, or of the next one there will be
  std::size_t stepped_ = 0;        // slots that hold a valid `next`
  std::size_t last_alive_ = 0;
  std::size_t next_alive_ = 0, next_last_ = 0;
  bool program_ended_ = false;
};

}  // namespace leadscrew::referee
