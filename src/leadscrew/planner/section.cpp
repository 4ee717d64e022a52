#include <algorithm>
#include <cmath>
#include <leadscrew/planner/section.hpp>
#include <limits>

namespace leadscrew::planner {

namespace {

constexpr double negligible_jerk =
    1e-4;  // of the limit of jerk: steps of velocity or acceleration that take no more in a period are passed

}  // namespace

geometry::PointJet one_sided_jets(const toolpath::AxisPath& axes, double s, Side side) {
  constexpr double aside = 4e-13;
  const double length = axes.length(), step = aside * length;
  return axes.jets(std::clamp(side == Side::left ? s - step : s + step, 0.0, length));
}

bool turns(const geometry::PointJet& jet) {
  return std::any_of(jet.begin(), jet.end(), [](const numeric::Jet<>& q) { return q.second != 0; });
}

void Section::append(const toolpath::Piece& piece) {
  pieces_.push_back(piece);
  offsets_.push_back(offsets_.back() + piece.axes().length());
}

double Section::forget_before(double s) {
  std::size_t gone = 0;
  while (gone + 1 < pieces_.size() && offsets_[gone + 1] <= s) ++gone;
  const double shift = offsets_[gone];
  const auto count = static_cast<std::ptrdiff_t>(gone);
  pieces_.erase(pieces_.begin(), pieces_.begin() + count);
  offsets_.erase(offsets_.begin(), offsets_.begin() + count);
  for (double& offset : offsets_) offset -= shift;
  return shift;
}

void Section::clear() {
  pieces_.clear();
  offsets_.assign(1, 0.0);
}

std::size_t Section::piece_at(double s, Side side) const {
  const auto begin = offsets_.begin() + 1, end = offsets_.end() - 1;
  const auto found = side == Side::left ? std::lower_bound(begin, end, s) : std::upper_bound(begin, end, s);
  return static_cast<std::size_t>(found - begin);
}

geometry::PointJet Section::jets(double s, Side side) const {
  const std::size_t index = piece_at(s, side);
  return one_sided_jets(pieces_[index].axes(), s - offsets_[index], side);
}

std::size_t Section::borders(double from, double to) const {
  const std::size_t first = piece_at(from, Side::right), last = piece_at(to, Side::left);
  std::size_t count = 0;
  for (std::size_t p = first; p <= last; ++p) {
    const toolpath::AxisPath axes = pieces_[p].axes();
    const double begin = p == first ? from - offsets_[p] : 0, length = axes.length();
    const double end = p == last ? std::min(to - offsets_[p], length) : length;
    if (begin < end) count += axes.borders(begin, end);
  }
  return count + (last > first ? last - first : 0);
}

bool runs_through(const geometry::PointJet& leaving, const geometry::PointJet& entering, double speed,
                  const machine::Machine& machine) {
  const double period = machine.period.seconds();
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    const std::size_t i = base::index(axis);
    const double kink = std::abs(leaving[i].first - entering[i].first);
    const double jump = std::abs(leaving[i].second - entering[i].second);
    if (kink == 0 && jump == 0) continue;
    const double negligible = negligible_jerk * machine.limits(axis).jerk;
    if (kink * speed > negligible * period * period || jump * speed * speed > negligible * period) return false;
  }
  return true;
}

}  // namespace leadscrew::planner
