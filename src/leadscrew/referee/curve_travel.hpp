#pragma once
// How far a motion went along a curve from word to word, at least.
//
// A word within a nanometre of the curve lies on it. Where the curve comes by more than once, as on both sides of a tip
// at which it turns back, the word may lie at each of these places, and counting from one that is not the right one
// would count the travel to the tip twice:
//
//     a ────────────● word before ──────●──╮      the second word may lie before the tip or behind it
//     b ────────────────────────────────●──╯
//
// So the least length is taken that places of both words in order allow. Nor do words tell of bends that a motion
// within a nanometre of the curve may cut: beside a curve of length L that turns by θ, a motion within δ of it, which
// begins at δ₀ and ends at δ₁ from the curve's ends, has a length of at least L − δ₀ − δ₁ − δθ (project it on the
// curve's tangents and integrate by parts). Where that is less than L by more than a ten-thousandth, the chord of the
// words counts.

#include <leadscrew/referee/candidate_set.hpp>
#include <vector>

namespace leadscrew::referee {

class CurveTravel {
 public:
  explicit CurveTravel(const Metric& metric) : metric_(metric) {}

  /// The word before does not lie on the curve that comes.
  void forget() { before_.clear(); }

  /// After a step whose last candidate is in this slot, all of them on one curve: the least length of the curve between
  /// the word before and this one over the length of its chord, in the axes of the feed. 1 where a word does not lie on
  /// it, or where the chord says too little.
  double observe(CandidateSet& candidates, std::size_t last);

 private:
  /// Where a word may lie.
  struct Place {
    std::int64_t serial = 0;  // of the piece
    double place = 0;         // on it
    double distance = 0;      // mm
  };

  void find_places(CandidateSet& candidates, std::size_t last);
  double stretch(CandidateSet& candidates, const Place& from, const Place& to, double& length) const;

  const Metric& metric_;
  std::vector<Place> before_, now_;  // in the order of the path
};

}  // namespace leadscrew::referee
