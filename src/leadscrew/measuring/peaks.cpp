#include <algorithm>
#include <cmath>
#include <leadscrew/measuring/peaks.hpp>
#include <leadscrew/numeric/vectors.hpp>

namespace leadscrew::measuring {

namespace {

constexpr std::size_t most_cells = 24;                   // of ridges, and of cuts
constexpr std::size_t most_candidates = 1 << 14;         // among which they are chosen
constexpr std::size_t most_tools = 1 << 14;              // of one cell
constexpr double least_ridge = 1e-7, least_cut = 1e-10;  // mm: less is rounding

/// The parabola through three places at 0, 1 and 2, at x.
double parabola(double a, double b, double c, double x) {
  return a + x * (b - a) + x * (x - 1) / 2 * (c - 2 * b + a);
}

/// Height of the crest about place k; its own where too little is known of one side.
double crest_at(const std::vector<double>& h, std::size_t k, double reach) {
  if (k < 3 || k + 3 >= h.size()) return h[k];
  const bool rises = h[k - 3] < h[k - 2] && h[k - 2]<h[k - 1], falls = h[k + 1]> h[k + 2] && h[k + 2] > h[k + 3];
  if (!rises || !falls) return h[k];
  const auto left = [&](double x) { return parabola(h[k - 3], h[k - 2], h[k - 1], x + 3); };
  const auto right = [&](double x) { return parabola(h[k + 3], h[k + 2], h[k + 1], 3 - x); };
  double from = -1, to = 1;
  if (left(from) > right(from) || left(to) < right(to)) return h[k];
  for (int step = 0; step < 40; ++step) {
    const double middle = (from + to) / 2;
    (left(middle) < right(middle) ? from : to) = middle;
  }
  return std::clamp(left(from), h[k], std::min(2 * h[k], reach));
}

bool is_beyond(const Peak& peak, const Peak& other, bool is_cut) {
  return is_cut ? peak.height < other.height : peak.height > other.height;
}

template <class Candidates, class Before>
void keep_first(Candidates& candidates, std::size_t count, Before before) {
  if (candidates.size() <= count) return std::sort(candidates.begin(), candidates.end(), before);
  std::partial_sort(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(count), candidates.end(),
                    before);
  candidates.resize(count);
}

}  // namespace

std::vector<Crossing> crossings_of(const std::vector<double>& heights, double reach) {
  std::vector<Crossing> crossings;
  for (std::size_t k = 1; k + 1 < heights.size(); ++k) {
    const double h = heights[k];
    if (h < least_ridge || h >= reach || h < heights[k - 1] || h <= heights[k + 1]) continue;
    crossings.push_back({k, crest_at(heights, k, reach)});
  }
  return crossings;
}

void Peaks::cross(const PlaceTree& map, bool along_columns, double reach) {
  const std::size_t lines = along_columns ? map.columns() : map.rows();
  std::vector<double> heights(along_columns ? map.rows() : map.columns());
  const auto higher = [](const Candidate& a, const Candidate& b) { return a.height > b.height; };
  for (std::size_t line = 0; line < lines; ++line) {
    for (std::size_t k = 0; k < heights.size(); ++k)
      heights[k] = along_columns ? map.at(line, k).height : map.at(k, line).height;
    for (const Crossing& crossing : crossings_of(heights, reach)) {
      sum_ += crossing.height;
      ++ridges_;
      ridge_candidates_.push_back(
          {along_columns ? line : crossing.place, along_columns ? crossing.place : line, crossing.height});
    }
    if (ridge_candidates_.size() > 4 * most_candidates) keep_first(ridge_candidates_, most_candidates, higher);
  }
}

/// And the highest place of all, which may be at a border.
void Peaks::find_cuts(const PlaceTree& map) {
  Candidate highest{0, 0, no_place};
  const auto deeper = [](const Candidate& a, const Candidate& b) { return a.height < b.height; };
  for (std::size_t j = 0; j < map.rows(); ++j) {
    for (std::size_t i = 0; i < map.columns(); ++i) {
      const double height = map.at(i, j).height;
      if (height == no_place) continue;
      if (height < reach_ && height > highest.height) highest = {i, j, height};
      if (height < -least_cut) cut_candidates_.push_back({i, j, height});
    }
    if (cut_candidates_.size() > 4 * most_candidates) keep_first(cut_candidates_, most_candidates, deeper);
  }
  keep_first(cut_candidates_, most_candidates, deeper);
  if (highest.height > 0) ridge_candidates_.insert(ridge_candidates_.begin(), highest);
}

/// Of the first candidates that are no neighbours.
void Peaks::make_cells(std::vector<Candidate>& candidates, const PlaceTree& map, const GridLines& lines, bool is_cut) {
  std::vector<Candidate> chosen;
  const auto is_near = [](const Candidate& a, const Candidate& b) {
    return std::max(a.i, b.i) - std::min(a.i, b.i) <= 1 && std::max(a.j, b.j) - std::min(a.j, b.j) <= 1;
  };
  for (const Candidate& candidate : candidates) {
    if (chosen.size() == most_cells) break;
    if (std::any_of(chosen.begin(), chosen.end(), [&](const Candidate& other) { return is_near(candidate, other); }))
      continue;
    chosen.push_back(candidate);
  }
  for (const Candidate& place : chosen) {
    const auto before = [](std::size_t k) { return k > 0 ? k - 1 : 0; };
    const auto behind = [](std::size_t k, std::size_t count) { return std::min(k + 1, count - 1); };
    const std::array<std::size_t, 3> i = {before(place.i), place.i, behind(place.i, map.columns())},
                                     j = {before(place.j), place.j, behind(place.j, map.rows())};
    Cell cell{{lines.u[i[0]], lines.u[i[2]]}, {lines.v[j[0]], lines.v[j[2]]}, is_cut, PlaceTree(3, 3, {3, 3}), {}};
    double highest = 0;
    for (std::size_t b = 0; b < 3; ++b) {
      for (std::size_t a = 0; a < 3; ++a) {
        cell.around.at(a, b) = map.at(i[a], j[b]);
        highest = std::max(highest, map.at(i[a], j[b]).height);
      }
    }
    cell.around.begin(std::min(reach_, std::max(1.5 * highest, place.height) + 1e-4));
    cells_.push_back(std::move(cell));
  }
  candidates.clear();
  candidates.shrink_to_fit();
}

void Peaks::choose(const PlaceTree& map, const GridLines& lines, const Target& target) {
  reach_ = target.reach;
  if (target.across != Target::Across::u) cross(map, true, reach_);
  if (target.across != Target::Across::v) cross(map, false, reach_);
  keep_first(ridge_candidates_, most_candidates,
             [](const Candidate& a, const Candidate& b) { return a.height > b.height; });
  find_cuts(map);
  make_cells(ridge_candidates_, map, lines, false);
  make_cells(cut_candidates_, map, lines, true);
  enclose_cells();
}

void Peaks::enclose_cells() {
  for (const Cell& cell : cells_) {
    for (std::size_t k = 0; k < 3; ++k) middle_[k] += cell.around.at(1, 1).s[k] / static_cast<double>(cells_.size());
  }
  for (const Cell& cell : cells_) {
    for (std::size_t place = 0; place < 9; ++place)
      far_ = std::max(far_, numeric::distance(cell.around.at(place % 3, place / 3).s, middle_));
  }
  far_ += std::max(0.0, reach_);
}

void Peaks::see(const SweptTool& tool, const WordPlace& word) {
  if (tool.least_distance(middle_).value > far_) return;
  for (Cell& cell : cells_) {
    if (cell.tools.size() < most_tools && cell.around.may_lower(tool)) cell.tools.push_back({tool, word});
  }
}

/// The last two that left least come first: near a crest one of them most likely does again, and the others are refused at
/// once.
Peak Peaks::height_at(std::vector<Kept>& tools, const Net& net, double u, double v) const {
  const SurfacePlace place = net.at(u, v);
  Peak peak{reach_, u, v, place.s, {}};
  std::size_t lowest = 0;
  for (std::size_t k = 0; k < tools.size(); ++k) {
    const SweptTool& tool = tools[k].tool;
    const double height = tool.entry(place.s, place.n, deepest_of(tool.body()), peak.height);
    if (height >= peak.height) continue;
    peak.height = height;
    peak.word = tools[k].word;
    lowest = k;
  }
  if (lowest > 1) std::swap(tools[1], tools[lowest]);
  if (lowest > 0) std::swap(tools[0], tools[1]);
  return peak;
}

/// Leaves those that may lower what is left in a part of a cell, where nothing is higher than `highest` by more than its size.
void Peaks::keep_near(std::vector<Kept>& tools, const Net& net, const surfaces::Range& u, const surfaces::Range& v,
                      double highest) const {
  PlaceTree around(3, 3, {3, 3});
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < 3; ++i) {
      const SurfacePlace place = net.at(u.from + (u.to - u.from) * static_cast<double>(i) / 2,
                                        v.from + (v.to - v.from) * static_cast<double>(j) / 2);
      around.at(i, j) = {place.s, place.n, 0};
    }
  }
  const double size = numeric::distance(around.at(0, 0).s, around.at(2, 2).s);
  around.begin(std::min(reach_, std::max(highest, 0.0) + size));
  std::erase_if(tools, [&](const Kept& kept) { return !around.may_lower(kept.tool); });
}

Peak Peaks::refined(Cell& cell, const Net& net) const {
  constexpr int parts = 8, rounds = 12;  // each time a quarter of the width
  surfaces::Range u = cell.u, v = cell.v;
  Peak best = height_at(cell.tools, net, (u.from + u.to) / 2, (v.from + v.to) / 2);
  for (int round = 0; round < rounds; ++round) {
    const double wide = (u.to - u.from) / parts, high = (v.to - v.from) / parts;
    for (int j = 0; j <= parts; ++j) {
      for (int i = 0; i <= parts; ++i) {
        const Peak found = height_at(cell.tools, net, u.from + i * wide, v.from + j * high);
        if (found.exists() && (!best.exists() || is_beyond(found, best, cell.is_cut))) best = found;
      }
    }
    u = {std::max(cell.u.from, best.u - wide), std::min(cell.u.to, best.u + wide)};
    v = {std::max(cell.v.from, best.v - high), std::min(cell.v.to, best.v + high)};
    keep_near(cell.tools, net, u, v, best.height);
  }
  return best;
}

void Peaks::refine(const Net& net) {
  for (Cell& cell : cells_) {
    const Peak peak = refined(cell, net);
    Peak& best = cell.is_cut ? cut_ : ridge_;
    if (peak.exists() && (!best.exists() || is_beyond(peak, best, cell.is_cut))) best = peak;
  }
  cells_.clear();
}

}  // namespace leadscrew::measuring
