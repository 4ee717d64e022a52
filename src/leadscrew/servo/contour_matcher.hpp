#pragma once
// Contour error: how far each place where the axes really were lies from the path they were to travel, whenever they
// were to be there.
//
//   path     ●────●────●────●────●        words, a straight line from each to the next
//             ╲    ╲   ╲     ╲
//   actual     ○────○───○─────○           each in the order of time: no match goes back along the path
//
// Nearest points will not do: where the path crosses itself, or a pass lies beside another, the nearest point may
// belong to another pass. What is wanted is the matching in order whose squares of distances have the least sum,
//
//   D(k, j) = |actual k, line j|² + min over i ≤ j of D(k − 1, i),
//
// which Viterbi's algorithm finds: D is kept for the lines of a window about the word that is due, and which line each
// came from, until as many periods later as the window is long the match is certain. Within one line order is not
// asked for. Words that stand add no line. Where the window would have more than 512 lines, only every so many periods
// are matched: stride().

#include <cstddef>
#include <cstdint>
#include <deque>
#include <leadscrew/base/axes.hpp>
#include <utility>
#include <vector>

namespace leadscrew::servo {

struct ContourWindow {
  int behind = 128;  ///< periods that axes may lag; ≥ 1
  int ahead = 32;    ///< periods that they may lead; ≥ 1
};

/// Of one period: mm and degrees; 0 in axes that are left out.
struct Contour {
  double distance = 0;         ///< mm, by the scale
  base::AxisVector actual{};   ///< where the axes were
  base::AxisVector nearest{};  ///< and where on the path they are matched to
};

class ContourMatcher {
 public:
  /// scale: what a mm or degree of each axis counts in a distance, mm; 0 leaves the axis out.
  ContourMatcher(const base::AxisVector& scale, const ContourWindow& window);

  /// One period: where the axes were to be, and where they were.
  void observe(const base::AxisVector& commanded, const base::AxisVector& actual);
  /// After the last period: settles what is left in doubt.
  void finish();

  /// What has been settled and not taken yet: of every stride()-th period, from the first on.
  std::vector<Contour> take() { return std::exchange(settled_, {}); }
  std::int64_t stride() const { return stride_; }

 private:
  using Point = base::AxisVector;

  struct Waiting {
    Point actual{};
    std::int64_t due = 0;  // vertex of the word
  };
  /// Of one period, for the lines first, first + 1, ….
  struct MatchRow {
    std::int64_t first = 0;
    std::vector<std::uint16_t> came_from;  // columns of the row before
    Point actual{};
    std::int64_t last_vertex = 0;  // that was known
  };

  Point scaled(const base::AxisVector& position) const;
  const Point& vertex(std::int64_t number) const { return path_[static_cast<std::size_t>(number) % path_.size()]; }
  double share_of(const Point& point, std::int64_t line, std::int64_t last) const;
  double squared_distance(const Point& point, std::int64_t line, std::int64_t last) const;
  Contour contour(const MatchRow& row, std::size_t column) const;
  void match(const Waiting& period);
  void settle(std::size_t count);

  Point scale_;
  std::vector<std::size_t> axes_;
  std::int64_t stride_, behind_, ahead_;  // periods; lines; lines
  std::int64_t periods_ = 0;
  std::vector<Point> path_;      // ring of vertices
  std::int64_t vertices_ = 0;    // so far; line j runs from vertex j to j + 1
  std::deque<Waiting> waiting_;  // until the path ahead is known
  std::vector<MatchRow> rows_;   // in doubt
  std::size_t in_doubt_ = 0;     // so many of them
  std::vector<double> sums_, sums_before_;
  std::int64_t first_ = 0;  // line of the first of sums_
  std::vector<Contour> settled_;
};

}  // namespace leadscrew::servo
