#include <algorithm>
#include <cmath>
#include <leadscrew/planner/section.hpp>
#include <limits>

namespace leadscrew::planner {

namespace {

constexpr double negligible_jerk =
    1e-4;  // of the limit of jerk: steps of velocity or acceleration that take no more in a period are passed

/// So little aside of s, 0 ≤ s ≤ length, that a step of the third derivative at s is told from which side it is seen.
double aside_of(double length, double s, Side side) {
  constexpr double aside = 4e-13;
  const double step = aside * length;
  return std::clamp(side == Side::left ? s - step : s + step, 0.0, length);
}

/// `path`: the jet of the curve's own coordinates there.
SeenPlace place_of_tip(const toolpath::Piece& piece, double s, const geometry::PointJet& path) {
  using toolpath::FeedAxes;
  SeenPlace seen{piece.transformation->axes_of(path), piece.feed, {}, piece.feed_axes != FeedAxes::none};
  if (piece.feed_axes == FeedAxes::contact)
    seen.speed = piece.greatest_speed(s, seen.jet);
  else if (piece.feed_axes != FeedAxes::none)
    seen.speed = piece.feed / toolpath::rate(path, piece.feed_axes);
  return seen;
}
geometry::PointJet path_jet(const toolpath::Piece& piece, double s, Side side) {
  return geometry::jets(piece.curve, aside_of(geometry::length(piece.curve), s, side));
}

}  // namespace

geometry::PointJet one_sided_jets(const toolpath::AxisPath& axes, double s, Side side) {
  return axes.jets(aside_of(axes.length(), s, side));
}

SeenPlace seen_place_without_chords(const toolpath::Piece& piece, double s, Side side) {
  if (piece.transformation) return place_of_tip(piece, s, path_jet(piece, s, side));
  SeenPlace seen{one_sided_jets(piece.axes(), s, side)};
  seen.speed = piece.greatest_speed(s, seen.jet);
  return seen;
}

SeenPlace seen_place(const toolpath::Piece& piece, double s, Side side) {
  if (!piece.transformation) {
    SeenPlace seen = seen_place_without_chords(piece, s, side);
    seen.chords.sagitta = piece.sagitta;
    return seen;
  }
  const geometry::PointJet path = path_jet(piece, s, side);
  SeenPlace seen = place_of_tip(piece, s, path);
  seen.chords = {piece.sagitta, kinematics::tip_bend(*piece.transformation, seen.jet, path)};
  return seen;
}

SeenPlaces side_by_side(const SeenPlace& first, const SeenPlace& second) {
  using numeric::Pair;
  SeenPlaces seen{.speed = {first.speed, second.speed}};
  for (std::size_t i = 0; i < seen.jet.size(); ++i) {
    const numeric::Jet<>&a = first.jet[i], &b = second.jet[i];
    seen.jet[i] = {Pair{a.value, b.value}, Pair{a.first, b.first}, Pair{a.second, b.second}, Pair{a.third, b.third}};
  }
  return seen;
}

SeenPlaces seen_places(const toolpath::Piece& piece, double first, Side first_side, double second, Side second_side) {
  using numeric::Pair;
  using toolpath::FeedAxes;
  const auto* const nurbs = std::get_if<geometry::Nurbs>(&piece.curve);
  if (!nurbs || (!piece.transformation && piece.feed_axes != FeedAxes::none)) {
    return side_by_side(seen_place_without_chords(piece, first, first_side),
                        seen_place_without_chords(piece, second, second_side));
  }
  const double length = nurbs->length();
  const Pair places = {aside_of(length, first, first_side), aside_of(length, second, second_side)};
  const Pair feed = numeric::all<Pair>(piece.feed);
  if (!piece.transformation) return {nurbs->jets(places), feed};
  const geometry::PointJetOf<Pair> path = nurbs->jets(places);
  SeenPlaces seen{piece.transformation->axes_of(path), feed};
  if (piece.feed_axes == FeedAxes::contact)
    seen.speed /= Pair{piece.feed_rate(first), piece.feed_rate(second)};
  else if (piece.feed_axes != FeedAxes::none)
    seen.speed /= toolpath::rate(path, piece.feed_axes);
  return seen;
}

numeric::PairBits turns(const geometry::PointJetOf<numeric::Pair>& jet) {
  numeric::PairBits turning{};
  for (const auto& q : jet) turning |= q.second != 0;
  return turning;
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

double greatest_speed_over_kink(const geometry::PointJet& leaving, const geometry::PointJet& entering,
                                const machine::Machine& machine) {
  const double period = machine.period.seconds();
  double speed = std::numeric_limits<double>::infinity();
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    const double kink = std::abs(leaving[base::index(axis)].first - entering[base::index(axis)].first);
    const double step = negligible_jerk * machine.limits(axis).jerk * period * period;
    if (kink * speed > step) speed = step / kink;
  }
  return speed;
}

bool runs_through(const geometry::PointJet& leaving, const geometry::PointJet& entering, double speed,
                  const machine::Machine& machine) {
  if (speed > greatest_speed_over_kink(leaving, entering, machine)) return false;
  const double period = machine.period.seconds();
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    const std::size_t i = base::index(axis);
    const double jump = std::abs(leaving[i].second - entering[i].second);
    if (jump == 0) continue;
    if (jump * speed * speed > negligible_jerk * machine.limits(axis).jerk * period) return false;
  }
  return true;
}

}  // namespace leadscrew::planner
