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
// Every piece of the path holds at most one candidate (frontier.hpp).
//
// Candidates beyond 1¼ tolerances and a nanometre are dropped, so that there is one nearly always, two where the path
// turns back or the block changes, and elsewhere as many as there are pieces within the tolerance. All are kept that
// can still turn out to be right: no choice is made at a tip or a crossing, so none can be wrong, and nothing
// accumulates.
//
// Each goes to the nearest place of its piece, which where words run back along a piece is not the best. So before all
// are found beyond the tolerance, or a deviation is told that is larger than any before by a sixteenth of the
// tolerance, the last words are judged again on finer pieces (appeal.hpp).
//
// Where all candidates lie beyond the tolerance, the trace departs from the program. Then others are tried ahead, up to
// 16 times the least cost away and 256 pieces far, until the best lies on its piece again.
//
// A deviation within the tolerance is told too large by an eighth of the tolerance at most: a sixteenth that is not
// doubted, and a sixteenth by what the finer pieces are long. One beyond it may be told larger, by what the best match
// lags behind where it is left late.

#include <cstdint>
#include <leadscrew/referee/appeal.hpp>
#include <leadscrew/referee/curve_travel.hpp>
#include <leadscrew/referee/frontier.hpp>
#include <leadscrew/referee/piece_source.hpp>
#include <optional>

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
  double stretch = 1;          ///< if both lie on the same curve: its length between them over their chord's, at least
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
  using Slot = Frontier::Slot;

  Slot& slot(std::size_t i) { return frontier_.slot(i); }

  bool doubtful(double cost, double margin, double tolerance) const;
  Passage follow(double excuse);
  Passage depart();
  void settle(std::size_t best, Passage& passage);
  void adopt();
  Passage passage(std::size_t last);

  PieceSource& source_;
  const Metric& metric_;
  Frontier frontier_;
  Appeal appeal_;
  Point start_{}, end_{};
  double deviation_ = 0;
  double confirmed_ = 0;  // mm; the largest cost that needs no second judgement
  bool departed_ = false;
  double least_margin_ = 0;  // while departed: of the best candidate

  /// Where the word before lies nearest to.
  struct Match {
    std::int64_t block = -1;
    double angle = 0;     // of an arc from the block's start, radians
    double distance = 0;  // mm
  } matched_;
  CurveTravel curve_travel_;
};

}  // namespace leadscrew::referee
