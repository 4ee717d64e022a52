#pragma once
// What cannot be designed: a value that is not above 0, or that a register would not hold. Codes: `not-positive`,
// `register-overflow`, `feed-too-low`, `feed-too-high`, `no-way`. Empty where all is well.

#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/design/dda_design.hpp>
#include <leadscrew/design/inverse_time.hpp>
#include <vector>

namespace leadscrew::design {

std::vector<base::Diagnostic> problems_of(const DdaRange& range);
/// Along a line, of a range that is sound.
std::vector<base::Diagnostic> problems_of(const DdaRange& range, const std::vector<double>& delta_mm,
                                          double feed_mm_min);
/// Of design_timer.
std::vector<base::Diagnostic> problems_of(double clock_pps, const std::vector<double>& delays);
std::vector<base::Diagnostic> problems_of(const InverseTimeRange& range);
/// Of a block, in a range that is sound.
std::vector<base::Diagnostic> problems_of(const InverseTimeRange& range, double distance, double feed);

}  // namespace leadscrew::design
