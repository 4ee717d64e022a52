#pragma once
// Random paths that can be travelled without a stop, on random machines.

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/planner/section.hpp>
#include <planned.hpp>
#include <random_numbers.hpp>
#include <vector>

namespace leadscrew::testing_support {

/// Limits over two to three decades, each axis its own; acceleration is reached in a millisecond or later.
inline machine::Machine random_machine() {
  machine::Machine machine = machine::mill3();
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z, base::Axis::A}) {
    const double acceleration = logarithmic(30, 1e4);
    machine.axes[base::index(axis)] =
        machine::AxisLimits{-1e6, 1e6, logarithmic(8, 500), acceleration, acceleration * logarithmic(3, 1000), 0.001};
  }
  return machine;
}

/// Shares of a whole, in order: 0, …, 1.
inline std::vector<double> random_shares(int most) {
  std::vector<double> shares = {0, 1};
  for (int k = any(0, most); k > 0; --k) shares.push_back(any(1, 100000) / 1e5);
  std::sort(shares.begin(), shares.end());
  shares.erase(std::unique(shares.begin(), shares.end()), shares.end());
  return shares;
}

/// One feed for all pieces, or one for each.
class RandomFeed {
 public:
  double next() {
    if (changes_) feed_ = logarithmic(1, 300);
    return feed_;
  }

 private:
  bool changes_ = any(0, 4) == 0;
  double feed_ = logarithmic(1, 300);
};

inline std::vector<toolpath::Piece> collinear_lines(int most_pieces) {
  geometry::Point end{};
  const double size = logarithmic(0.05, 200);
  for (const std::size_t i : {0, 1, 2, 3}) end[i] = size * any(-100, 101) / 100.0;
  if (end[0] == 0) end[0] = size;
  const std::vector<double> shares = random_shares(most_pieces);
  RandomFeed feed;
  std::vector<toolpath::Piece> pieces;
  geometry::Point at{};
  for (std::size_t k = 1; k < shares.size(); ++k) {
    geometry::Point next = end;
    for (double& x : next) x *= shares[k];
    pieces.push_back(line_piece(at, next, feed.next(), static_cast<int>(k)));
    at = next;
  }
  return pieces;
}

/// Parts of one helix, or of an arc where it does not rise.
inline std::vector<toolpath::Piece> parts_of_a_helix(int most_pieces) {
  const double radius = logarithmic(0.05, 100), angle = logarithmic(0.05, 15) * (*rc::gen::arbitrary<bool>() ? 1 : -1);
  const double rise = *rc::gen::element(0.0, 0.3, -2.0) * radius, turn = *rc::gen::element(0.0, 30.0);
  const std::size_t first = any<std::size_t>(0, 3), second = (first + 1) % 3, normal = (first + 2) % 3;
  const double phase = any(0, 6283) / 1000.0;
  const auto at = [&](double share) {
    geometry::Point point{};
    point[first] = radius * std::cos(phase + share * angle);
    point[second] = radius * std::sin(phase + share * angle);
    point[normal] = share * rise;
    point[3] = share * turn;
    return point;
  };
  const std::vector<double> shares = random_shares(most_pieces);
  RandomFeed feed;
  std::vector<toolpath::Piece> pieces;
  for (std::size_t k = 1; k < shares.size(); ++k) {
    const double share = shares[k] - shares[k - 1];
    pieces.push_back({geometry::Arc(at(shares[k - 1]), at(shares[k]), first, second, 0, 0, share * angle,
                                    geometry::Arc::helix_length(radius, share * angle, share * rise)),
                      feed.next(), base::Line{static_cast<std::int64_t>(k)}});
  }
  return pieces;
}

/// A uniform cubic B-spline in three coordinates, C2 all along, cut into curves at some of its knots: each has the
/// control points that bear upon it, unclamped. Control points go round in a wavy way, so that nothing like a cusp
/// comes.
inline std::vector<toolpath::Piece> cubic_curves(int most_spans) {
  const int spans = any(1, most_spans + 1);
  const double size = logarithmic(0.5, 60), step = any(2, 10) / 10.0;
  std::vector<geometry::Point> points;
  for (int k = 0; k < spans + 3; ++k) {
    const double angle = k * step, radius = size * (1 + any(-100, 101) / 1000.0);
    points.push_back({radius * std::cos(angle), radius * std::sin(angle), size * k * 0.05});
  }
  RandomFeed feed;
  std::vector<toolpath::Piece> pieces;
  for (int from = 0; from < spans;) {
    const int count = std::min(any(1, 6), spans - from);
    geometry::NurbsForm form{3, {}, {points.begin() + from, points.begin() + from + count + 3}, {}};
    form.weights.assign(form.points.size(), 1.0);
    for (int k = 0; k < count + 7; ++k) form.knots.push_back(from + k);
    const double speed = feed.next();
    for (const geometry::Nurbs& piece : geometry::smooth_pieces(form)) {
      pieces.push_back({piece, speed, base::Line{from + 1}});
    }
    from += count;
  }
  return pieces;
}

inline std::vector<toolpath::Piece> random_path(int most_pieces) {
  switch (any(0, 3)) {
    case 0:
      return collinear_lines(most_pieces);
    case 1:
      return parts_of_a_helix(most_pieces);
    default:
      return cubic_curves(std::min(most_pieces + 3, 60));
  }
}

/// Lowers jerk until the length of a ramp to full speed, 2v√(v/J), is at least the path's length divided by `ramps`, so
/// that no path takes too many knots to test with.
inline void soften(machine::Machine& machine, const std::vector<toolpath::Piece>& pieces, double ramps) {
  double length = 0, slowest = 1e300;
  for (const toolpath::Piece& piece : pieces) {
    length += geometry::length(piece.curve);
    slowest = std::min(slowest, piece.feed);
  }
  for (const auto& axis : machine.axes) {
    if (axis) slowest = std::min(slowest, axis->velocity);
  }
  const double greatest = 4 * slowest * slowest * slowest * (ramps / length) * (ramps / length);
  for (auto& axis : machine.axes) {
    if (axis) axis->jerk = std::min(axis->jerk, greatest);
  }
}

inline planner::Section section_of(const std::vector<toolpath::Piece>& pieces) {
  planner::Section section;
  for (const toolpath::Piece& piece : pieces) section.append(piece);
  return section;
}

}  // namespace leadscrew::testing_support
