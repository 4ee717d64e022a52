#pragma once
// The problem that a speed profile solves, fixed once it is made: where x(s) = ṡ² is looked at, the rows that bound it
// there and the greatest x.
//
// With the coefficients c of the cubic spline x, b = x′/2 = s̈ and c = x″/2, a row of constraints/row.hpp is linear in
// the four coefficients that bear upon its interval: A by its limit and g by its limit, so that
//
//     |A| ≤ 1          g²x ≤ 1
//
// Rows stand at every knot and, as the middle ordinate of the parabola through an interval's ends and middle (the
// "hull"), between knots; at some places more where the curve's derivatives have a peak inside an interval.

#include <array>
#include <cstddef>
#include <cstdint>
#include <leadscrew/constraints/constraints.hpp>
#include <leadscrew/planner/cubic_basis.hpp>
#include <leadscrew/planner/knots.hpp>
#include <leadscrew/planner/lanes.hpp>
#include <leadscrew/planner/section.hpp>
#include <span>
#include <vector>

namespace leadscrew::planner {

/// Greatest x: of the coefficients, which holds between knots as well; at the knots; in the middle of the intervals.
struct SquareCaps {
  std::vector<double> coefficients, knots, middles;
};

class SpeedProblem {
 public:
  /// Rows of two pairs of limits as functions of the four coefficients of the interval, by their limits: for each
  /// coefficient A and g of the one pair, then of the other. What is missing is 0.
  struct Block {
    std::array<Lanes, 4> by{};
  };
  /// A place of an interval where rows are kept; `x` is what g² is multiplied by.
  struct Site {
    std::uint32_t interval = 0, first_block = 0, end_block = 0;
    bool hull = false;
    std::int8_t place = -1;  ///< which of the interval's places it is; −1: none of them
    std::uint8_t pairs = 0;  ///< of rows
    Four x{};
  };
  /// Values of the basis at four places of an interval, for each coefficient: those of numeric::gauss_3_places, the
  /// second of which is the middle, and the end.
  using Places = std::array<Lanes, 4>;
  static constexpr std::int8_t middle_place = 1, end_place = 3;

  /// Programmed feed is multiplied by `feed_factor`. `before`: of the window that this one goes on from, with the same
  /// constraints; what it has seen between the same knots is not looked at again.
  SpeedProblem(const Section& section, const constraints::Constraints& constraints, Knots knots, double feed_factor,
               const SpeedProblem* before = nullptr);

  const Knots& knots() const { return knots_; }
  std::size_t intervals() const { return knots_.intervals; }
  bool starts_at_rest() const { return knots_.start_ramp > 0; }
  bool ends_at_rest() const { return knots_.end_ramp > 0; }
  bool ends_in_creep() const { return !ends_at_rest() && !knots_.free_end; }
  std::span<const CubicBasis> basis() const { return basis_; }
  /// Of every interval.
  std::span<const Places> places() const { return places_; }
  std::span<const Site> sites() const { return sites_; }
  std::span<const Block> blocks() const { return blocks_; }
  /// As asked by feed and every other limit of speed.
  const SquareCaps& caps() const { return caps_; }
  /// Coefficients of the creep profile; any between 0 and these are inside every row, those tied kept in proportion.
  std::span<const double> creep() const { return creep_; }

  /// How many inequalities the barrier keeps.
  std::size_t inequalities() const { return 2 * (pairs_ + caps_.coefficients.size() + intervals()) + 1; }

  // Coefficients that are one variable: three at a rest, in the ratio of x ∝ s^(4/3); all in the creep before an end in
  // motion. Three are given where the window begins in motion.

  std::size_t variables() const { return variable_count_; }
  bool is_free(std::size_t coefficient) const { return variable_[coefficient] >= 0; }
  /// Of a free coefficient.
  std::size_t variable(std::size_t coefficient) const { return static_cast<std::size_t>(variable_[coefficient]); }
  /// Coefficient over variable.
  double weight(std::size_t coefficient) const { return weight_[coefficient]; }

  /// x at a place of the site, and the largest ratio of its rows for these coefficients; infinite where x ≤ 0.
  double greatest_ratio(const Site& site, std::span<const double> c) const;

  /// Every place on the section is less by `by`.
  void shift(double by);
  /// Gives back the memory that only solving takes.
  void settle();

 private:
  class Builder;
  /// Greatest x as it was found at the knots and in the middle of the intervals, for the window that goes on.
  struct SeenCaps {
    std::vector<double> knots, middles;
    std::vector<bool> speed_varies;  ///< of each interval: its caps are by a feed that varies
    std::vector<bool> steps;         ///< at each knot: may the cap be another behind it?
  };
  void find_creep();
  void tie_creep();
  void tie_variables();
  double bound_of_rows(const Site& site) const;
  std::span<const Block> blocks(const Site& site) const {
    return {blocks_.data() + site.first_block, blocks_.data() + site.end_block};
  }

  Knots knots_;
  double feed_factor_;
  std::vector<CubicBasis> basis_;
  std::vector<Places> places_;
  std::vector<Site> sites_;
  std::vector<Block> blocks_;
  std::size_t pairs_ = 0;  ///< of rows
  SquareCaps caps_;
  SeenCaps seen_;
  std::array<double, 3> start_tie_{}, end_tie_{};
  std::vector<double> creep_;
  std::vector<std::int32_t> variable_;  ///< of each coefficient; −1 if it is given
  std::vector<double> weight_;
  std::size_t variable_count_ = 0;
};

}  // namespace leadscrew::planner
