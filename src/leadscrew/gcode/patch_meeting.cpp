#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/patch_meeting.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <limits>

namespace leadscrew::gcode {

namespace {

using machine::ProbePatch;
using machine::Vector;

constexpr double meeting_tolerance = 1e-10;  // mm
constexpr double smallest_cell = 2e-10;      // mm
constexpr std::size_t most_cells = 20'000;   // that are looked at

/// Coordinates in which patches are looked at: two across, one along.
struct View {
  Vector origin{};
  std::array<Vector, 3> axes{};
  double tolerance = 0;     ///< across, mm
  double from = 0, to = 0;  ///< along, mm
  double smallest = 0;      ///< mm
};

/// A part of a patch, by its net in those coordinates: weight times each, and the weight.
struct PatchCell {
  std::array<std::size_t, 2> terms{};  // points in u and v
  std::array<std::array<double, 4>, 36> net;
  double nearest = 0;  // no place of it lies before, along

  std::array<double, 4>& point(std::size_t i, std::size_t j) { return net[i + j * terms[0]]; }
  const std::array<double, 4>& point(std::size_t i, std::size_t j) const { return net[i + j * terms[0]]; }
  std::size_t size() const { return terms[0] * terms[1]; }
  double at(std::size_t k, std::size_t axis) const { return net[k][axis] / net[k][3]; }
};

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double width() const { return high - low; }
};

std::array<Extent, 3> extents_of(const PatchCell& cell) {
  std::array<Extent, 3> extents;
  for (std::size_t k = 0; k < cell.size(); ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) extents[axis].add(cell.at(k, axis));
  }
  return extents;
}

/// Across the longer diagonal, as it is seen along the line.
Extent extent_across(const PatchCell& cell) {
  const std::size_t corners[] = {0, cell.size() - 1, cell.terms[0] - 1, cell.size() - cell.terms[0]};
  std::array<double, 2> longest{};
  double length = 0;
  for (std::size_t k = 0; k < 4; k += 2) {
    const std::array<double, 2> diagonal = {cell.at(corners[k + 1], 0) - cell.at(corners[k], 0),
                                            cell.at(corners[k + 1], 1) - cell.at(corners[k], 1)};
    if (numeric::norm(diagonal) <= length) continue;
    longest = diagonal;
    length = numeric::norm(diagonal);
  }
  Extent extent;
  if (length == 0) return {0, 0};
  for (std::size_t k = 0; k < cell.size(); ++k)
    extent.add((longest[0] * cell.at(k, 1) - longest[1] * cell.at(k, 0)) / length);
  return extent;
}

bool holds_zero(const Extent& extent, double tolerance) {
  return extent.low <= tolerance && extent.high >= -tolerance;
}

/// The longest row of the net along u, or along v.
double row_length(const PatchCell& cell, std::size_t direction) {
  double longest = 0;
  for (std::size_t row = 0; row < cell.terms[1 - direction]; ++row) {
    double length = 0;
    for (std::size_t k = 1; k < cell.terms[direction]; ++k) {
      const std::size_t a = direction == 0 ? k - 1 + row * cell.terms[0] : row + (k - 1) * cell.terms[0];
      const std::size_t b = direction == 0 ? a + 1 : a + cell.terms[0];
      length += std::abs(cell.at(b, 0) - cell.at(a, 0)) + std::abs(cell.at(b, 1) - cell.at(a, 1)) +
                std::abs(cell.at(b, 2) - cell.at(a, 2));
    }
    longest = std::max(longest, length);
  }
  return longest;
}

/// Halves by de Casteljau's algorithm: the cell becomes its first half, the other one is returned.
PatchCell split_off(PatchCell& cell, std::size_t direction) {
  PatchCell second = cell;
  const std::size_t last = cell.terms[direction] - 1;
  const std::size_t step = direction == 0 ? 1 : cell.terms[0], row_step = direction == 0 ? cell.terms[0] : 1;
  for (std::size_t row = 0; row < cell.terms[1 - direction]; ++row) {
    const std::size_t base = row * row_step;
    // In `second` the points move down to the second half; the first of each round is one of the first half.
    for (std::size_t round = 1; round <= last; ++round) {
      for (std::size_t k = 0; k + round <= last; ++k) {
        std::array<double, 4>& a = second.net[base + k * step];
        const std::array<double, 4>& b = second.net[base + (k + 1) * step];
        for (std::size_t i = 0; i < 4; ++i) a[i] = (a[i] + b[i]) / 2;
      }
      cell.net[base + round * step] = second.net[base];
    }
  }
  return second;
}

bool is_farther(const PatchCell& a, const PatchCell& b) {
  return a.nearest > b.nearest;
}

/// Cells that may meet, the nearest first.
class Search {
 public:
  explicit Search(const View& view) : view_(view) {}

  void add(const ProbePatch& patch) {
    PatchCell cell;
    cell.terms = {static_cast<std::size_t>(patch.degree[0]) + 1, static_cast<std::size_t>(patch.degree[1]) + 1};
    for (std::size_t k = 0; k < cell.size(); ++k) {
      const auto& [x, y, z, w] = patch.net[k];
      const Vector from = numeric::difference(Vector{x, y, z}, view_.origin);
      for (std::size_t i = 0; i < 3; ++i) cell.net[k][i] = w * numeric::dot(view_.axes[i], from);
      cell.net[k][3] = w;
    }
    keep(cell);
  }

  /// The least place along at which a patch is met.
  std::optional<double> first() {
    for (std::size_t seen = 0; !cells_.empty(); ++seen) {
      std::ranges::pop_heap(cells_, is_farther);
      PatchCell cell = cells_.back();
      cells_.pop_back();
      const std::array<Extent, 3> extents = extents_of(cell);
      const double width = std::max({extents[0].width(), extents[1].width(), extents[2].width()});
      if (width <= view_.smallest || seen == most_cells) return std::clamp(cell.nearest, view_.from, view_.to);
      const PatchCell second = split_off(cell, row_length(cell, 0) >= row_length(cell, 1) ? 0 : 1);
      keep(cell);
      keep(second);
    }
    return std::nullopt;
  }

 private:
  void keep(PatchCell cell) {
    const std::array<Extent, 3> extents = extents_of(cell);
    if (extents[2].high < view_.from || extents[2].low > view_.to) return;
    if (!holds_zero(extents[0], view_.tolerance) || !holds_zero(extents[1], view_.tolerance)) return;
    if (!holds_zero(extent_across(cell), view_.tolerance)) return;
    cell.nearest = extents[2].low;
    cells_.push_back(cell);
    std::ranges::push_heap(cells_, is_farther);
  }

  View view_;
  std::vector<PatchCell> cells_;  // a heap
};

/// Unit vectors across d, a unit vector, and d.
std::array<Vector, 3> axes_along(const Vector& d) {
  std::size_t least = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (std::abs(d[i]) < std::abs(d[least])) least = i;
  }
  Vector unit{};
  unit[least] = 1;
  Vector a = numeric::sum(unit, -d[least], d);
  const double length = numeric::norm(a);
  for (double& value : a) value /= length;
  const Vector b = {d[1] * a[2] - d[2] * a[1], d[2] * a[0] - d[0] * a[2], d[0] * a[1] - d[1] * a[0]};
  return {a, b, d};
}

std::optional<double> search(const std::vector<ProbePatch>& patches, const View& view) {
  Search search(view);
  for (const ProbePatch& patch : patches) search.add(patch);
  return search.first();
}

}  // namespace

std::optional<double> first_meeting(const std::vector<ProbePatch>& patches, const Vector& from, const Vector& to) {
  Vector d = numeric::difference(to, from);
  const double length = numeric::norm(d);
  if (!(length > 0)) return std::nullopt;
  for (double& value : d) value /= length;
  const auto place = search(patches, {from, axes_along(d), meeting_tolerance, 0, length, smallest_cell});
  return place ? std::optional(*place / length) : std::nullopt;
}

bool is_near_patch(const std::vector<ProbePatch>& patches, const Vector& point, double distance) {
  const std::array<Vector, 3> axes = {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};
  return search(patches, {point, axes, distance, -distance, distance, distance / 8}).has_value();
}

}  // namespace leadscrew::gcode
