#include <array>
#include <leadscrew/study/studies.hpp>

namespace leadscrew::study {

namespace {

constexpr std::array<Study, 3> all = {{
    {"butterfly", "The butterfly by arc length, and the times of travelling it", butterfly_rows},
    {"feed-fluctuation", "Feed and chord errors of the rules that step a curve's parameter", feed_fluctuation_rows},
    {"limits", "Time, limits and effort along curves beside the optimum, and along blended lines and corners",
     limits_rows},
}};

}  // namespace

std::span<const Study> studies() {
  return all;
}

}  // namespace leadscrew::study
