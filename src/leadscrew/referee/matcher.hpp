#pragma once
// Which point of the programmed path each word belongs to, in order, and how far the two are apart, both ways.
//
// Nearest points will not do: a slot milled back and forth, a circle milled three times or a path that crosses itself
// have several, and a path that was left out has none. What is wanted is the matching that keeps the order and makes
// the largest distance smallest (Fréchet's distance between the words and the path), under one excuse for sampling:
//
//     words   ───●───────────●───
//                 ╲__chord__╱        Of the path between the points matched to two consecutive words, nothing may lie
//     path    ─────╲__╱╲___╱────     farther from the chord between the words than the tolerance and a·T²/8.
//                       ▲ excused
//
// A motion whose acceleration is at most a leaves the chord of a period T by no more: f'' is bounded and f = 0 at both
// ends. Whatever lies farther was skipped. How large a can have been is for excuse.hpp to say.
//
// Every piece of the path holds at most one candidate: the place matched to the latest word if that word is on this
// piece, and the largest distance that led there. From word to word,
//
//     cost'(piece) = max(distance of the word to the piece, min(cost(piece), carried)),
//     carried      = min over earlier pieces of max(cost, largest distance of all between to the chord − a·T²/8).
//
// Candidates beyond 1¼ tolerances and a nanometre are dropped, so that there is one nearly always, two where the path
// turns back or the block changes, and elsewhere as many as there are pieces within the tolerance. All are kept that
// can still turn out to be right: no choice is made at a tip or a crossing, so none can be wrong, and nothing
// accumulates.
//
// Where all candidates lie beyond the tolerance, the trace departs from the program. Then others are tried ahead, up to
// 16 times the least cost away and 256 pieces far, until the best lies on its piece again. A deviation up to 1¼
// tolerances is the least there is; a larger one may be told too large, by what the best match lags behind where it is
// left late.

#include <cstdint>
#include <leadscrew/referee/piece_source.hpp>
#include <limits>
#include <optional>
#include <vector>

namespace leadscrew::referee {

/// Something held against the trace.
struct Finding {
  base::Line line{};
  double value = 0;  ///< mm
  double limit = 0;  ///< mm
};

/// From one word to the next, along the path.
struct Passage {
  base::Line line{};    ///< of the block the word lies nearest to
  ProgrammedFeed feed;  ///< greatest of the blocks the two words may lie on; infinite if they tell it in different axes
  const Piece* arc = nullptr;  ///< if both words lie on the same arc: a piece of it
  double turn = 0;             ///< and the angle between them, radians
  double stretch = 1;          ///< if both lie on the same curve: its length between them over their chord's
  std::optional<Finding> deviation;
  std::optional<Finding> skipped;
};

class Matcher {
 public:
  Matcher(PieceSource& source, const Metric& metric);

  /// Returns where the first word is matched to.
  Passage begin(const Point& word);
  /// `excuse`: how far from the chord to this word the motion may have been unseen (SamplingExcuse), mm.
  Passage observe(const Point& word, double excuse);

  /// The rest of the program, seen from the last word; what of it lies beyond its tolerance, the very end apart.
  std::optional<Finding> conclude();

  const Point& path_start() const { return start_; }
  const Point& path_end() const { return end_; }   ///< after conclude()
  double deviation() const { return deviation_; }  ///< mm; complete after conclude()

 private:
  static constexpr double none = -std::numeric_limits<double>::infinity();

  /// A possible match. Margins are distances less the tolerance at their place.
  struct Candidate {
    bool alive = false;
    double place = 0;           // on its piece
    double distance = 0;        // mm; from there to the latest word, or to the chord where path was passed over
    double cost = 0;            // mm; largest distance since the candidates were last one
    double margin = none;       // mm; likewise
    double skip = 0;            // mm; largest distance of path between words to their chord, less the excuse
    double skip_margin = none;  // mm
    base::Line skip_line{};
  };

  struct Slot {
    Piece piece;
    Candidate now;
    Candidate next;
  };

  /// How far candidates may go in one step, beside a share of the tolerance.
  struct Reach {
    double carry = nanometre;  // mm; margin up to which path is passed over
    double keep = nanometre;   // mm; margin up to which a candidate is kept
    std::size_t pieces = 0;    // ahead
  };

  Slot& slot(std::size_t i) { return slots_[(front_ + i) & (slots_.size() - 1)]; }
  bool pull();
  void drop_front();

  std::size_t step(const Reach& reach);
  Candidate candidate_on(const Slot& slot, const Candidate& carried);
  Candidate past_bend(const Slot& slot, double distance, const Candidate& carried) const;
  void pass_to_end(std::size_t i, double most, Candidate& candidate);
  void pass_bend(const Piece& piece, double to, double distance, Candidate& candidate) const;
  void pass_over(double distance, double tolerance, base::Line line, Candidate& candidate) const;

  Passage follow();
  Passage depart();
  void settle(std::size_t best, Passage& passage);
  void adopt();
  Passage passage(std::size_t last);
  double stretch_to(std::size_t nearest);

  PieceSource& source_;
  const Metric& metric_;
  double excuse_ = 0;
  Chord chord_;
  Point word_{};
  Point start_{}, end_{};
  double deviation_ = 0;

  std::vector<Slot> slots_;  // a ring; its size is a power of two
  std::size_t front_ = 0, count_ = 0;
  std::size_t stepped_ = 0;     // slots that hold a valid `next`
  std::size_t last_alive_ = 0;  // the last slot whose `now` is alive
  std::size_t next_alive_ = 0;  // number of `next` alive
  std::size_t next_last_ = 0;   // the last of them
  bool program_ended_ = false;
  bool departed_ = false;
  double least_margin_ = 0;  // while departed: of the best candidate

  /// Where the word before lies nearest to.
  struct Match {
    std::int64_t block = -1;
    std::int64_t number = 0;  // of the piece, if that is of a curve
    double place = 0;         // on the piece; of an arc from the block's start, radians
    double distance = 0;      // mm
  } matched_;
};

}  // namespace leadscrew::referee
