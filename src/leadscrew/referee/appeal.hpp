#pragma once
// Judges the last few words again, more closely, when the first judgement would object or finds a larger deviation than
// ever before.
//
// A candidate goes to the nearest place of its piece and never back, so where words run back along a piece it is told
// too far by up to the piece's length (frontier.hpp). Here pieces are cut so fine that this is next to nothing: into
// parts of a sixteenth of the tolerance, except the middle of a piece much longer than the tolerance, along which no
// motion within the tolerance has a reason to run back. Where more than 512 parts are in reach, the rest is left
// whole.
//
//      ├┼┼┼┼┼┼┼┼┼───────────────────────┼┼┼┼┼┼┼┼┼┤      4 tolerances at either end
//
// That is many times the work, so it is done for few words. What it begins from, and the words since, are recorded on
// the way: candidates before words at least three tolerances apart,
//
//     ──▲─ · · · · · · ─▲─ · · · · · ●      older mark, newer mark, latest word
//
// so that a hearing reaches back by three tolerances at least, farther than the choice of a place can matter. Of words
// too dense for that the last 4096 are recorded at least. Words stay under appeal for three tolerances more.

#include <leadscrew/referee/frontier.hpp>
#include <optional>
#include <vector>

namespace leadscrew::referee {

class Appeal {
 public:
  /// `whole`: where the pieces come from, and what they look like uncut.
  Appeal(const Metric& metric, Frontier& whole);
  Appeal(const Appeal&) = delete;
  Appeal& operator=(const Appeal&) = delete;

  /// Records from the whole pieces' candidates at their latest word on.
  void begin();
  /// A word, `excuse` as Frontier::observe takes it.
  void record(const Point& word, double excuse);
  /// Marks the whole pieces' candidates if the words have come far from the last mark; tolerance: the largest, mm.
  void mark(double tolerance);
  /// Closes the appeal and records no more until the next mark.
  void forget();

  bool recording() const { return recording_; }
  /// Serial number of the first piece that is still needed, while recording.
  std::int64_t first_needed() const { return older_.candidates.front().serial; }

  /// Opens the appeal: judges all recorded words again. Returns whether they are within the tolerance; if not, it is
  /// not opened.
  bool hear();
  bool open() const { return open_; }
  /// One more word while it is open. Returns whether it is within the tolerance; if not, the appeal is closed.
  bool observe(const Point& word, double excuse);
  /// Closes the appeal if the words have come far from where it was opened.
  void close(double tolerance);

  /// After hear() and observe(): cost of the candidate with the least margin, mm.
  double least_cost() { return parts_.slot(best_).next.cost; }
  /// Likewise: makes the parts' candidates `next` of the pieces they are parts of.
  void transfer();
  /// The rest of the program from the last word, opened if need be; nothing if it cannot be.
  std::optional<Frontier::End> conclude();

 private:
  struct Word {
    Point point{};
    double excuse = 0;
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
    double fine = 1;  // share of a part; the one in the middle may have more

    Cuts() = default;
    Cuts(const Metric& metric, const Piece& piece);
    double operator[](int i) const;
  };

  void set(Mark& mark);
  bool begin_parts();
  bool next_part(Piece& part);
  bool judge(const Point& word, double excuse);
  bool near(const Point& place, double tolerance) const;

  const Metric& metric_;
  Frontier& whole_;
  Frontier parts_;
  Mark older_, newer_;
  bool recording_ = false;
  bool open_ = false;
  Point opened_{};
  std::size_t best_ = 0;  // slot of the parts

  // The piece that is being cut.
  std::int64_t serial_ = 0;
  Cuts cuts_;
  int cut_ = 0;  // parts of it there have been
};

}  // namespace leadscrew::referee
