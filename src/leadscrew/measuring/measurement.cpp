#include <algorithm>
#include <cmath>
#include <leadscrew/measuring/measurement.hpp>
#include <leadscrew/numeric/vectors.hpp>

namespace leadscrew::measuring {

namespace {

constexpr std::size_t steps_at_once = 1 << 17;

/// A grid line's share of its neighbours' intervals.
double share_of(const std::vector<double>& lines, std::size_t k) {
  const double before = k > 0 ? lines[k] - lines[k - 1] : 0;
  const double behind = k + 1 < lines.size() ? lines[k + 1] - lines[k] : 0;
  return (before + behind) / 2;
}

/// Grids are finer across the passes.
PlaceTree::Block block_of(const Target& target) {
  switch (target.across) {
    case Target::Across::u:
      return {8, 2};
    case Target::Across::v:
      return {2, 8};
    case Target::Across::both:
      break;
  }
  return {4, 4};
}

/// What is higher is looked at in a reading of its own, if there is any: of places that no pass has come to yet, every word that
/// is somewhere near would be the lowest so far.
double first_reach(const Target& target) {
  return target.expected > 0 ? std::min(target.reach, 4 * target.expected + 1e-3) : target.reach;
}

}  // namespace

Measurement::Measurement(Target target)
    : target_(std::move(target)),
      net_(target_.form, target_.side),
      lines_(grid_of(target_)),
      tree_(lines_.u.size(), lines_.v.size(), block_of(target_)) {
  std::vector<Basis> columns;
  for (const double u : lines_.u) columns.push_back(net_.basis(surfaces::Direction::u, u));
  area_.reserve(lines_.u.size() * lines_.v.size());
  for (std::size_t j = 0; j < lines_.v.size(); ++j) {
    const Basis row = net_.basis(surfaces::Direction::v, lines_.v[j]);
    for (std::size_t i = 0; i < lines_.u.size(); ++i) {
      const SurfacePlace place = net_.at(columns[i], row);
      tree_.at(i, j) = {place.s, place.n, 0};
      area_.push_back(static_cast<float>(place.area * share_of(lines_.u, i) * share_of(lines_.v, j)));
    }
  }
  tree_.begin(first_reach(target_));
}

void Measurement::add(const ToolPose& pose, const ToolBody& body, const WordPlace& word, bool joined) {
  words_.add(pose, body, word, joined, [this](const WordStep& step) { take(step); });
}

void Measurement::take(const WordStep& step) {
  if (stage_ == Stage::done) return;
  if (stage_ == Stage::peaks) return peaks_.see(step.tool, step.word);
  steps_.push_back(step);
  if (steps_.size() >= steps_at_once) lower_all();
}

/// First every 256th, then those in the middle between them, and so on.
void Measurement::lower_all() {
  const auto lower = [&](const WordStep& step) {
    if (tree_.lower(step.tool)) findings_.chord = std::max(findings_.chord, step.chord);
  };
  constexpr std::size_t widest = 256;
  for (std::size_t k = 0; k < steps_.size(); k += widest) lower(steps_[k]);
  for (std::size_t stride = widest / 2; stride > 0; stride /= 2) {
    for (std::size_t k = stride; k < steps_.size(); k += 2 * stride) lower(steps_[k]);
  }
  steps_.clear();
}

bool Measurement::end_reading() {
  words_.end([this](const WordStep& step) { take(step); });
  if (stage_ == Stage::done) return false;
  if (stage_ != Stage::peaks) {
    lower_all();
    const bool is_first = stage_ == Stage::near && first_reach(target_) < target_.reach;
    stage_ = Stage::far;
    if (is_first && tree_.raise(first_reach(target_), target_.reach)) return true;
    stage_ = Stage::peaks;
    survey();
    peaks_.choose(tree_, lines_, target_);
    return true;
  }
  stage_ = Stage::done;
  peaks_.refine(net_);
  findings_.ridge = peaks_.ridge();
  findings_.cut = peaks_.cut();
  findings_.mean_ridge = peaks_.mean_ridge();
  findings_.ridges = peaks_.ridges();
  return false;
}

void Measurement::survey() {
  double reached = 0, sum = 0;
  for (std::size_t j = 0; j < tree_.rows(); ++j) {
    for (std::size_t i = 0; i < tree_.columns(); ++i) {
      const double area = area_[j * tree_.columns() + i], height = tree_.at(i, j).height;
      findings_.area += area;
      if (height >= target_.reach) {
        findings_.not_reached += area;
      } else if (height != no_place) {
        reached += area;
        sum += area * height;
      }
    }
  }
  findings_.mean_height = reached > 0 ? sum / reached : 0;
}

}  // namespace leadscrew::measuring
