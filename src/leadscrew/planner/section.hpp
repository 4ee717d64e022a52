#pragma once
// A section of path: smooth pieces joined with continuous curvature, travelled from rest to rest.

#include <deque>
#include <leadscrew/constraints/row.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/toolpath/path.hpp>
#include <vector>

namespace leadscrew::planner {

/// Which of the two one-sided values is meant where a derivative by path length jumps.
enum class Side : std::uint8_t { left, right };

/// Derivatives of axes at s, or so little aside of it that a step of the third derivative at s is told from which
/// side it is seen.
geometry::PointJet one_sided_jets(const toolpath::AxisPath& axes, double s, Side side);

/// What limits ask of a place on a piece. Where the piece has a transformation all of it comes of one jet of the curve's own
/// coordinates, which costs more than all that is made of it.
struct SeenPlace {
  geometry::PointJet jet{};      ///< of axes, as one_sided_jets() has it
  double speed = 0;              ///< greatest by programmed feed, units of path length per second
  constraints::Chords chords{};  ///< of those between words
  bool speed_varies = false;     ///< along the piece: where feed is that of the tip or of a contact

  /// `feed_factor`: of the programmed feed. This must outlive it.
  constraints::Place at_feed(double feed_factor) const { return {jet, feed_factor * speed, chords}; }
};
SeenPlace seen_place(const toolpath::Piece& piece, double s, Side side);
/// Without what chords between words leave.
SeenPlace seen_place_without_chords(const toolpath::Piece& piece, double s, Side side);

/// Of two places on one path, side by side.
struct SeenPlaces {
  geometry::PointJetOf<numeric::Pair> jet{};
  numeric::Pair speed{};

  constraints::PlaceOf<numeric::Pair> at_feed(double feed_factor) const { return {jet, feed_factor * speed, {}}; }
};
SeenPlaces side_by_side(const SeenPlace& first, const SeenPlace& second);
/// On one piece, each to the last bit as alone.
SeenPlaces seen_places(const toolpath::Piece& piece, double first, Side first_side, double second, Side second_side);

/// Does the direction of the path turn here: is any q″ other than 0?
bool turns(const geometry::PointJet& jet);
/// At each of the two: all bits, or none.
numeric::PairBits turns(const geometry::PointJetOf<numeric::Pair>& jet);

/// Of those between words on a piece; `jet` is that of its axes at s.
inline constraints::Chords chords_of(const toolpath::Piece& piece, double s, const geometry::PointJet& jet) {
  constraints::Chords chords{.sagitta = piece.sagitta, .bend = {}};
  if (piece.transformation)
    chords.bend = kinematics::tip_bend(*piece.transformation, jet, geometry::jets(piece.curve, s));
  return chords;
}

class Section {
 public:
  /// Joined to the end of what is there.
  void append(const toolpath::Piece& piece);
  void clear();
  /// Forgets the pieces that end at or before `s`; returns by how much less every place on the section now is.
  double forget_before(double s);

  bool empty() const { return pieces_.empty(); }
  std::size_t size() const { return pieces_.size(); }
  /// Units of the pieces' length, from the section's beginning; offset(size()) is its length.
  double offset(std::size_t piece) const { return offsets_[piece]; }
  double length() const { return offsets_.back(); }
  const toolpath::Piece& piece(std::size_t index) const { return pieces_[index]; }
  const std::deque<toolpath::Piece>& pieces() const { return pieces_; }

  /// The piece on which `s` lies; where pieces meet, the one on that side.
  std::size_t piece_at(double s, Side side) const;
  /// Position and derivatives by path length.
  geometry::PointJet jets(double s, Side side) const;
  /// How many polynomials there are from one place to another, less one.
  std::size_t borders(double from, double to) const;
  SeenPlace see(double s, Side side) const {
    const std::size_t index = piece_at(s, side);
    return seen_place(pieces_[index], s - offsets_[index], side);
  }
  /// By programmed feed, units/s; `jet` is the section's there.
  double greatest_speed(double s, Side side, const geometry::PointJet& jet) const {
    const std::size_t index = piece_at(s, side);
    return pieces_[index].greatest_speed(s - offsets_[index], jet);
  }

 private:
  std::deque<toolpath::Piece> pieces_;
  std::vector<double> offsets_{0.0};
};

inline double squared(double v) {
  return v * v;
}

/// The greatest speed, units/s, at which words at the machine's period do not show that a piece ends with `leaving` and the next
/// begins with `entering`, by their first derivatives; infinite where these agree. A kink Δq′ is a step Δq′·v of an axis' velocity,
/// which over one period T looks like a jerk of Δq′·v/T²; that must stay below 1e-4 of its limit.
double greatest_speed_over_kink(const geometry::PointJet& leaving, const geometry::PointJet& entering,
                                const machine::Machine& machine);

/// May motion run from one piece into the next without a stop, at `speed`, the greatest there? By their kink as above, and where
/// second derivatives jump by Δq″, the step Δq″·v² of an axis' acceleration must look like a jerk, Δq″·v²/T, no greater than
/// that.
bool runs_through(const geometry::PointJet& leaving, const geometry::PointJet& entering, double speed,
                  const machine::Machine& machine);

}  // namespace leadscrew::planner
