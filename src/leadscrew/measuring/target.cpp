#include <algorithm>
#include <cmath>
#include <leadscrew/measuring/net.hpp>
#include <leadscrew/measuring/target.hpp>
#include <leadscrew/numeric/vectors.hpp>

namespace leadscrew::measuring {

namespace {

constexpr std::size_t fewest_lines = 9;
constexpr double coarser_along = 4;  // along the passes the heights change slowly

double parameter(const surfaces::Range& range, std::size_t k, std::size_t intervals) {
  return k == intervals
             ? range.to
             : range.from + (range.to - range.from) * static_cast<double>(k) / static_cast<double>(intervals);
}

std::vector<double> spread(const surfaces::Range& range, double count) {
  const auto intervals = static_cast<std::size_t>(std::max(count, static_cast<double>(fewest_lines - 1)));
  std::vector<double> parameters;
  for (std::size_t k = 0; k <= intervals; ++k) parameters.push_back(parameter(range, k, intervals));
  return parameters;
}

}  // namespace

double length_along(const Target& target, surfaces::Direction direction) {
  constexpr std::size_t lines = 8, chords = 64;
  const Net net(target.form, target.side);
  double longest = 0;
  for (std::size_t line = 0; line <= lines; ++line) {
    double length = 0;
    Vector before{};
    for (std::size_t k = 0; k <= chords; ++k) {
      const bool is_u = direction == surfaces::Direction::u;
      const double u = is_u ? parameter(target.u, k, chords) : parameter(target.u, line, lines);
      const double v = is_u ? parameter(target.v, line, lines) : parameter(target.v, k, chords);
      const Vector s = net.at(u, v).s;
      if (k > 0) length += numeric::distance(s, before);
      before = s;
    }
    longest = std::max(longest, length);
  }
  return longest;
}

GridLines grid_of(const Target& target) {
  const double spacing = target.step / target.places_per_step;
  double along_u = length_along(target, surfaces::Direction::u) / spacing;
  double along_v = length_along(target, surfaces::Direction::v) / spacing;
  const auto most = static_cast<double>(target.most_places);
  if (target.across == Target::Across::v) along_u /= coarser_along;
  if (target.across == Target::Across::u) along_v /= coarser_along;
  along_u = std::max(along_u, 64.0);
  along_v = std::max(along_v, 64.0);
  const double excess = along_u * along_v / (0.98 * most);
  if (excess > 1) {
    // First less along the passes, down to a sixteenth and 64 lines; then less of both.
    double& slow = target.across == Target::Across::v ? along_u : along_v;
    if (target.across != Target::Across::both) slow = std::max({slow / excess, slow / 4, 64.0});
    const double left = std::max(1.0, along_u * along_v / (0.98 * most));
    along_u = std::min(std::max(along_u / std::sqrt(left), 8.0), most / 9 - 1);
    along_v = std::min(std::max(along_v / std::sqrt(left), 8.0), most / (along_u + 1) - 1);
  }
  return {spread(target.u, std::floor(along_u)), spread(target.v, std::floor(along_v))};
}

}  // namespace leadscrew::measuring
