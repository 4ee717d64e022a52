#pragma once
// Which point of the programmed path each word belongs to, in order, and the distance between words and path in both
// directions.
//
// Nearest points will not do: a slot milled back and forth, a circle milled three times or a path that crosses itself
// has several, and a path that was left out has none. The matching wanted keeps the order and makes the largest
// distance smallest (Fréchet's distance between the words and the path), with one allowance for sampling:
//
//     words   ───●───────────●───
//                 ╲__chord__╱        Of the path between the points matched to two consecutive words, nothing may lie
//     path    ─────╲__╱╲___╱────     farther from the chord between the words than the tolerance and a·T²/8.
//                       ▲ allowed
//
// A motion whose acceleration is at most a leaves the chord of a period T by no more: f'' is bounded and f = 0 at both
// ends. Path that lies farther was skipped. sampling_allowance.hpp bounds a. The tolerance is each block's own; where two
// blocks meet, the lesser of both.
//
// Every piece of the path holds at most one candidate (candidate_set.hpp). Candidates beyond 1¼ tolerances and a
// nanometre are dropped. So there is one nearly always, two where the path turns back or the block changes, and
// elsewhere as many as there are pieces within the tolerance. All that can still turn out to be right are kept: at a
// tip or a crossing no choice is made, so none can be wrong.
//
// Each goes to the nearest place of its piece, which is not the best where words run back along the piece. So before
// all are found beyond the tolerance, or a deviation is reported that exceeds all before by a sixteenth of the
// tolerance, the last words are matched again on finer pieces (rematch.hpp).
//
// Where all candidates lie beyond the tolerance, the trace departs from the program. Then others are tried ahead, up to
// 16 times the least cost away and 256 pieces far, until the best lies on its piece again.
//
// A deviation within the tolerance is reported at most an eighth of the tolerance too large: a sixteenth for which no
// rematch is made, and a sixteenth for the length of the finer pieces. One beyond the tolerance may come out larger, by
// what the best match lags behind where it is left late.

#include <cstdint>
#include <leadscrew/referee/candidate_set.hpp>
#include <leadscrew/referee/curve_travel.hpp>
#include <leadscrew/referee/piece_source.hpp>
#include <leadscrew/referee/rematch.hpp>
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
  base::Line line{};             ///< of the block the word lies nearest to
  double block_feed = 0;         ///< of that block, mm/s or degrees/s; infinite for a rapid
  std::array<double, 3> tool{};  ///< in it: its offset, mm
  double distance = 0;           ///< of the word from there, mm
  double tolerance = 0;          ///< of that block, mm
  ProgrammedFeed feed;  ///< greatest of the blocks the two words may lie on; infinite if they tell it in different axes
  const Piece* arc = nullptr;  ///< if both words lie on the same arc: a piece of it
  double turn = 0;             ///< and the angle between them, radians
  double stretch = 1;          ///< if both lie on the same curve: its length between them over their chord's, at least
  Point place{};               ///< where the word is matched to, if the matcher tells places
  double orientation_tolerance = 0;  ///< of the block the word lies nearest to, degrees
  std::optional<Finding> deviation;
  std::optional<Finding> skipped;
};

class Matcher {
 public:
  /// tells_places: Passage::place is wanted.
  Matcher(PieceSource& source, const Metric& metric, Cancellation& cancellation, bool tells_places = false);

  /// Returns where the first word is matched to.
  Passage begin(const Point& word);
  /// `allowance`: how far the motion may have been from the chord to this word (SamplingAllowance), mm.
  Passage observe(const Point& word, double allowance);

  /// After the last word: the rest of the program counts as skipped where it lies beyond its tolerance from that word.
  /// The distance of the program's end itself is not reported here.
  std::optional<Finding> conclude();

  /// How far the word before is beyond the tolerance while the trace departs from the program, mm; else 0.
  double departure() const { return departed_ ? least_margin_ : 0; }
  /// Is the word before matched to the path's last piece, within `reach`, mm, of its end?
  bool is_at_end(double reach);
  /// Would this word, the next one, be farther along the path than the word before, and no farther beyond the tolerance?
  bool leads_on(const Point& word, double allowance);

  const Point& path_start() const { return start_; }
  const Point& path_end() const { return end_; }   ///< after conclude()
  double deviation() const { return deviation_; }  ///< mm; complete after conclude()

 private:
  using Slot = CandidateSet::Slot;

  Slot& slot(std::size_t i) { return candidates_.slot(i); }

  bool needs_rematch(double cost, double margin, double tolerance) const;
  Passage follow(double allowance);
  bool leaves_the_next(std::size_t best);
  Passage depart();
  void rejoin(std::size_t best, Passage& passage);
  void adopt();
  Passage passage(std::size_t last);

  PieceSource& source_;
  const Metric& metric_;
  bool tells_places_;
  CandidateSet candidates_;
  Rematch rematch_;
  Point start_{}, end_{};
  double deviation_ = 0;
  double confirmed_ = 0;  // mm; the largest cost that needs no rematch
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
