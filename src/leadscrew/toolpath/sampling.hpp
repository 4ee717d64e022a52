#pragma once
// How a tolerance is divided where motion is rounded: between the curve, which departs by ε from what was programmed,
// and the chords between words, which depart by ε_s from the curve. Both keep the tolerance P where
//
//     ε + ε_s ≤ P,     ε_s = A T²/8,
//
// T the servo period, A the acceleration across the path (chord_error.hpp; braking before a corner and behind it adds to
// that where T is longer than its blend takes, no more than at a stop). The wider the curve, the faster motion may pass,
// and the greater A; at the limit of jerk j both obey the same law whatever the shape,
//
//     A = k ε^(1/3) j^(2/3),     time saved beside a stop ~ ε^(1/3).
//
// So the best division is where motion that jerk alone limits just keeps the sum: a wider curve would be travelled more
// slowly for the chords' sake, a narrower one leaves some of P unused. A is no more than what acceleration allows, nor
// than the programmed feed needs on the curve, whose bend is as C/ε: A = C F²/ε. k and C of
//
//   a blend that swings wide     q″ = c p″(½)(t_B − t_A) in its middle, c = ε/(p(½) Δ), Δ = |t_B − t_A|, passed in
//     (swing.hpp)                (6c/j)^(1/3):  k = p″(½) p(½)^(−1/3) (Δ/6)^(2/3),  C = p″(½) p(½) Δ²/(p′(½)²(4 − Δ²))
//   a blend that only cuts       q″ = 3c(t_B − t_A), c = 8ε/Δ, passed in (6c/j)^(1/3):  k = 24 (Δ/48)^(2/3),
//                                C = ⅔ Δ²/(4 − Δ²)
//   a spline at a joint          its curvature rises to Δ/l and falls within ±l, so that ε = lΔ/6 at the joint, and
//                                V³Δ/l² = j:  k = 6^(1/3),  C = Δ²/6
//
// Where the period is long beside the time that a blend takes, the law leaves it next to nothing. Motion may then be
// slowed for the chords' sake: a blend that only cuts is still no slower than a stop with twice the ε of the law, and one
// that is too small to be shown is left out.

#include <cstdint>
#include <leadscrew/geometry/point.hpp>
#include <leadscrew/machine/derivatives.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/toolpath/leg.hpp>

namespace leadscrew::toolpath {

/// How a corner is rounded: by a blend that swings wide, by one that only cuts it, or not at all.
enum class Rounding : std::uint8_t { wide, cut, none };

struct Division {
  double kept = 0;  ///< of P, for chords, mm
  Rounding rounding = Rounding::wide;
};

class Sampling {
 public:
  /// Words as close as may be: nothing is kept for chords.
  Sampling() = default;
  /// Words at the machine's period.
  explicit Sampling(const machine::Machine& machine);

  /// May chords ever need a share of P? Where A T²/8 at the machine's acceleration is no more than its chord error, never.
  bool needs_share() const;
  /// Of P for chords, mm, where a spline is fitted to the leg; 0 where the machine's chord error is enough.
  double kept_beside_spline(const Leg& leg) const;
  /// Is motion through a spline at a joint at the end of the leg, |t⁺ − t⁻| its turn, no slower than one that slows down
  /// to a corner? To pass the curve's bend ±l at V = (A l/Δ)^(1/2) takes as long as to come to rest from l before the
  /// joint and to go on where l/V = (6l/j)^(1/3): ε = 6 A³/(jΔ)².
  bool suits_spline(const Leg& leg, double turn) const;
  /// Where the corner between two pieces, or two legs, is blended within P.
  Division at_corner(const Piece& before, const Piece& behind, double tolerance, const ToleranceSpace& space) const;
  Division at_joint(const Leg& before, const Leg& behind, double tolerance) const;
  /// The same by two directions, by mm of the space of tolerances; `speed`: the greatest by feed there, mm/s.
  /// are_lines: are both straight?
  Division beside_blend(double tolerance, const geometry::Point& leaving, const geometry::Point& entering, double speed,
                        bool are_lines) const;

 private:
  /// What bounds acceleration across the path.
  struct Bend {
    double acceleration = 0;  ///< of the axes, mm/s²
    double by_jerk = 0;       ///< k j^(2/3)
    double by_feed = 0;       ///< C F²
  };
  double largest_deviation(double tolerance, const Bend& bend) const;
  /// Of the axes along a direction, or of all that move; infinite where none of X, Y and Z does.
  machine::Derivatives limits_along(const geometry::Point& direction) const;
  machine::Derivatives limits_along(const Leg& leg) const;

  double per_acceleration_ = 0;  ///< T²/8, s²
  double chord_error_ = 0;       ///< mm
  geometry::Point acceleration_{}, jerk_{};
};

}  // namespace leadscrew::toolpath
