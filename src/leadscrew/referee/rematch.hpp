#pragma once
// Matches the last few words to the path once more, on finer pieces, where the first matching would object or finds a
// larger deviation than any before.
//
// A candidate goes to the nearest place of its piece and never back. Where words run back along a piece, its distance
// comes out too large by up to the piece's length (candidate_set.hpp). A rematch cuts pieces into parts of a sixteenth
// of the tolerance, which bounds this error. The middle of a piece much longer than the tolerance stays whole: no
// motion within the tolerance runs back along it. Where 512 parts are held already, further pieces stay whole.
//
//      ├┼┼┼┼┼┼┼┼┼───────────────────────┼┼┼┼┼┼┼┼┼┤      4 tolerances at either end
//
// Parts are many times the work, so only few words are rematched. Recorded for that are the candidates before two
// words at least three tolerances apart, the marks, and all words since:
//
//     ──▲─ · · · · · · ─▲─ · · · · · ●      older mark, newer mark, latest word
//
// A rematch begins at the older mark, at least three tolerances back, which is farther than the choice of a place can
// matter. Of words so dense that 4096 of them come no farther, at least the last 4096 are recorded. Once begun it goes
// on with each word until the words are three tolerances farther.

#include <leadscrew/referee/candidate_set.hpp>
#include <optional>
#include <vector>

namespace leadscrew::referee {

class Rematch {
 public:
  /// `whole`: where the pieces come from, and what they look like uncut.
  Rematch(const Metric& metric, CandidateSet& whole, Cancellation& cancellation);
  Rematch(const Rematch&) = delete;
  Rematch& operator=(const Rematch&) = delete;

  /// Sets both marks at the latest word of the whole pieces and records from there on.
  void start_recording();
  /// The next word and its sampling allowance, mm, as CandidateSet::observe takes them.
  void record(const Point& word, double allowance);
  /// Sets a new mark if the words have come far enough from the last one; tolerance: the largest, mm.
  void advance_mark(double tolerance);
  /// Ends the rematch, if one is running, and records no more until the next mark.
  void stop();

  bool recording() const { return recording_; }
  /// Serial number of the first piece that is still needed, while recording.
  std::int64_t first_needed() const { return older_.candidates.front().serial; }

  /// Matches all recorded words again. Returns whether they are within the tolerance; then the rematch is running.
  /// False once cancelled.
  bool run();
  bool running() const { return running_; }
  /// One more word while it is running. Returns whether it is within the tolerance; if not, the rematch ends.
  bool observe(const Point& word, double allowance);
  /// Ends the rematch if the words have come three tolerances from where it was begun.
  void stop_when_far(double tolerance);

  /// After run() and observe(): cost of the candidate with the least margin, mm.
  double least_cost() { return parts_.slot(best_).next.cost; }
  /// After run() and observe(): makes the parts' candidates `next` of the whole pieces.
  void transfer_candidates();
  /// The rest of the program from the last word; std::nullopt if the recorded words are not within the tolerance or
  /// their pieces are no longer held.
  std::optional<CandidateSet::End> conclude();

 private:
  struct Word {
    Point point{};
    double allowance = 0;
  };
  struct Placed {
    std::int64_t serial = 0;
    Candidate candidate;
  };
  /// Candidates at a word, and the words after it.
  struct Mark {
    Point word{};
    std::vector<Placed> candidates;
    std::vector<Word> words;
  };

  /// Where a piece is cut: shares of its span.
  struct Cuts {
    int count = 1;
    double fine = 1;  // share of a part; the part in the middle may be longer

    Cuts() = default;
    Cuts(const Metric& metric, const Piece& piece);
    double operator[](int i) const;
  };

  void set(Mark& mark);
  bool begin_parts();
  bool next_part(Piece& part);
  bool judge(const Point& word, double allowance);
  bool near(const Point& place, double tolerance) const;

  const Metric& metric_;
  Cancellation& cancellation_;
  CandidateSet& whole_;
  CandidateSet parts_;
  Mark older_, newer_;
  bool recording_ = false;
  bool running_ = false;
  Point started_at_{};
  std::size_t best_ = 0;  // slot of the parts

  // The piece that is being cut.
  std::int64_t serial_ = 0;
  Cuts cuts_;
  int cut_ = 0;  // number of its parts handed out
};

}  // namespace leadscrew::referee
