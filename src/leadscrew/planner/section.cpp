#include <algorithm>
#include <cmath>
#include <leadscrew/planner/section.hpp>
#include <limits>

namespace leadscrew::planner {

namespace {

constexpr double unseen = 1e-4;  // of the limit of jerk

}  // namespace

geometry::PointJet one_sided_jets(const geometry::Curve& curve, double s, Side side) {
  constexpr double aside = 4e-13;
  const double length = geometry::length(curve), step = aside * length;
  return geometry::jets(curve, std::clamp(side == Side::left ? s - step : s + step, 0.0, length));
}

bool turns(const geometry::PointJet& jet) {
  return std::any_of(jet.begin(), jet.end(), [](const numeric::Jet<>& q) { return q.second != 0; });
}

void Section::append(const toolpath::Piece& piece) {
  pieces_.push_back(piece);
  offsets_.push_back(offsets_.back() + geometry::length(piece.curve));
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
  return one_sided_jets(pieces_[index].curve, s - offsets_[index], side);
}

std::size_t Section::borders(double from, double to) const {
  const std::size_t first = piece_at(from, Side::right), last = piece_at(to, Side::left);
  std::size_t count = 0;
  for (std::size_t p = first; p <= last; ++p) {
    const geometry::Curve& curve = pieces_[p].curve;
    const double begin = p == first ? from - offsets_[p] : 0, length = geometry::length(curve);
    const double end = p == last ? std::min(to - offsets_[p], length) : length;
    if (begin < end) count += geometry::borders(curve, begin, end);
  }
  return count + (last > first ? last - first : 0);
}

bool runs_through(const geometry::PointJet& leaving, const geometry::PointJet& entering, double speed,
                  const machine::Machine& machine) {
  const double period = machine.period.seconds();
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    const double kink = std::abs(leaving[i].first - entering[i].first);
    const double jump = std::abs(leaving[i].second - entering[i].second);
    if (kink == 0 && jump == 0) continue;
    const double granted = unseen * machine.limits(axis).jerk;
    if (kink * speed > granted * period * period || jump * speed * speed > granted * period) return false;
  }
  return true;
}

}  // namespace leadscrew::planner
