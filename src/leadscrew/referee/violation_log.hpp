#pragma once
// The violations of a trace: all counted, the first 1000 listed.

#include <algorithm>
#include <leadscrew/referee/referee.hpp>
#include <utility>

namespace leadscrew::referee {

/// A ratio above this is a violation: 0.1 % beyond a limit.
inline constexpr double objectionable_ratio = 1.001;

inline constexpr std::size_t most_violations_listed = 1000;

class ViolationLog {
 public:
  void add(double t, base::Line line, const char* what, double value, double limit) {
    ++count_;
    if (ordinary_.size() < most_violations_listed) ordinary_.push_back({t, line, what, value, limit});
  }

  /// For kinds of which there are few: listed before all others, so that a long departure does not hide them.
  void add_rare(double t, base::Line line, const char* what, double value, double limit) {
    ++count_;
    if (rare_.size() < most_violations_listed) rare_.push_back({t, line, what, value, limit});
  }

  /// Lists without counting and counts without listing, for checks that know only at the end which ones count.
  void list(Violation violation) { ordinary_.push_back(std::move(violation)); }
  void add_count(std::int64_t count) { count_ += count; }

  void conclude(Verdict& verdict) {
    const auto earlier = [](const Violation& a, const Violation& b) { return a.t < b.t; };
    std::stable_sort(ordinary_.begin(), ordinary_.end(), earlier);
    rare_.insert(rare_.end(), ordinary_.begin(), ordinary_.end());
    if (rare_.size() > most_violations_listed) rare_.resize(most_violations_listed);
    std::stable_sort(rare_.begin(), rare_.end(), earlier);
    verdict.violation_count = count_;
    verdict.violations = std::move(rare_);
  }

 private:
  std::int64_t count_ = 0;
  std::vector<Violation> ordinary_, rare_;
};

}  // namespace leadscrew::referee
