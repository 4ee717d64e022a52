#pragma once
// Words that a motion along a path may have, told from the words alone.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cut_motion.hpp>
#include <leadscrew/base/word.hpp>

namespace leadscrew::testing_support {

/// Looks at words one after another: no jump of position, speed or acceleration along the path anywhere, that is, third
/// differences within the jerk; ticks without a gap; every position on the path (closed, if it is gone round again) at
/// the length that the word tells.
class SmoothWords {
 public:
  SmoothWords(const Path& path, double jerk, base::Period period)
      : path_(path), length_(path.length()), jerk_step_(jerk * std::pow(period.seconds(), 3)) {}

  void look(const base::Word& word) {
    if (count_ > 0 && base::count(word.tick) != base::count(last_.tick) + 1) ++gaps_;
    std::rotate(s_.rbegin(), s_.rbegin() + 1, s_.rend());
    s_[0] = word.path_length;
    if (++count_ >= 4) jerk_ = std::max(jerk_, std::abs(s_[0] - 3 * s_[1] + 3 * s_[2] - s_[3]) / jerk_step_);
    const double laps = std::floor(word.path_length / length_), s = word.path_length - laps * length_;
    // The end of the path belongs to it.
    const geometry::Point there = path_.at(s < 1e-7 && laps > 0 ? length_ : s);
    for (std::size_t i = 0; i < 3; ++i) aside_ = std::max(aside_, std::abs(word.position[i] - there[i]));
    last_ = word;
  }

  std::int64_t count() const { return count_; }
  const base::Word& last() const { return last_; }
  std::int64_t gaps() const { return gaps_; }
  double jerk() const { return jerk_; }    ///< greatest, by the limit
  double aside() const { return aside_; }  ///< greatest, mm

 private:
  const Path& path_;
  double length_, jerk_step_;
  std::array<double, 4> s_{};
  base::Word last_;
  std::int64_t count_ = 0, gaps_ = 0;
  double jerk_ = 0, aside_ = 0;
};

}  // namespace leadscrew::testing_support
