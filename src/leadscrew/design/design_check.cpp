#include <algorithm>
#include <cmath>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/design/design_check.hpp>
#include <leadscrew/numeric/rounded_up.hpp>
#include <string>
#include <utility>

namespace leadscrew::design {

namespace {

using Problems = std::vector<base::Diagnostic>;

constexpr double greatest_register = 1 << 30;  // of a design: 30 bits

std::string text(double value) {
  return base::text(value, 10);
}

void add(Problems& problems, std::string_view code, std::string message, std::string hint) {
  problems.push_back(base::problem(code, std::move(message), std::move(hint)));
}

struct Named {
  const char* name;
  double value;
};

void check_positive(Problems& problems, std::initializer_list<Named> values) {
  for (const auto& [name, value] : values) {
    if (!(value > 0)) add(problems, "not-positive", std::string(name) + " is " + text(value), "it must be above 0");
  }
}

/// A register that would hold this value, of so many bits or digits.
void check_register(Problems& problems, const std::string& name, double value, double greatest,
                    const std::string& hint) {
  if (value <= greatest * (1 + numeric::quotient_rounding)) return;
  add(problems, "register-overflow",
      name + " would have to hold " + text(value) + ": no more than " + text(greatest) + " fits", hint);
}

std::string bits_text(int bits) {
  return " of " + std::to_string(bits) + " bits";
}

double greatest_of(int bits) {
  return std::ldexp(1.0, bits) - 1;
}

void check_feed(Problems& problems, double feed, double max_feed) {
  if (feed <= max_feed * (1 + numeric::quotient_rounding)) return;
  add(problems, "feed-too-high", "the feed of " + text(feed) + " is above the greatest, " + text(max_feed),
      "design for a greater one");
}

/// A feed word that would be 0 is none.
void check_word(Problems& problems, const char* name, double word) {
  if (word >= 0.5) return;
  add(problems, "feed-too-low", "feed word " + std::string(name) + " is " + text(word) + ": as an integer it is 0",
      "the feed is too low for the distance");
}

}  // namespace

Problems problems_of(const DdaRange& range) {
  Problems problems;
  check_positive(problems, {{"the travel", range.travel_mm},
                            {"the BLU", range.blu_mm},
                            {"the greatest feed", range.max_feed_mm_min},
                            {"the least distance", range.min_distance_mm}});
  if (!problems.empty()) return problems;
  check_register(problems, "the axes' register", range.travel_mm / range.blu_mm, greatest_register - 1,
                 "a smaller travel or a larger BLU would do");
  check_register(problems, "the feed register S", 10 * range.max_feed_mm_min / range.min_distance_mm,
                 greatest_register - 1, "a lower feed or a longer least distance would do");
  return problems;
}

Problems problems_of(const DdaRange& range, const std::vector<double>& delta_mm, double feed_mm_min) {
  Problems problems;
  check_positive(problems, {{"the feed", feed_mm_min}});
  const DdaDesign design = design_dda(range);
  double square = 0;
  for (std::size_t axis = 0; axis < delta_mm.size(); ++axis) {
    const double pulses = std::round(std::abs(delta_mm[axis]) / range.blu_mm);
    check_register(problems, "the register of axis " + std::to_string(axis + 1) + bits_text(design.axis_bits), pulses,
                   greatest_of(design.axis_bits), "design for a greater travel");
    square += pulses * pulses;
  }
  if (square == 0)
    add(problems, "no-way", "the line ends where it starts, or within half a BLU of it",
        "give an end away from the start");
  if (!problems.empty()) return problems;
  check_feed(problems, feed_mm_min, range.max_feed_mm_min);
  const double word = 10 * feed_mm_min / range.blu_mm / std::sqrt(square);
  check_word(problems, "S", word);
  check_register(problems, "the feed register S" + bits_text(design.feed_bits), std::round(word),
                 greatest_of(design.feed_bits), "the line is shorter than the least distance that was designed for");
  return problems;
}

Problems problems_of(double clock_pps, const std::vector<double>& delays) {
  Problems problems;
  check_positive(problems, {{"the clock", clock_pps}});
  for (const double delay : delays) check_positive(problems, {{"the delay", delay}});
  if (!problems.empty() || delays.empty()) return problems;
  const double longest = *std::max_element(delays.begin(), delays.end());
  check_register(problems, "the timer's register", longest * clock_pps, greatest_register,
                 "a shorter delay or a slower clock would do");
  if (!problems.empty()) return problems;
  const DdaTimer timer = design_timer(clock_pps, delays);
  for (std::size_t i = 0; i < delays.size(); ++i) {
    check_register(problems,
                   "the timer's register" + bits_text(timer.bits) + ", for the delay of " + text(delays[i]) + " s,",
                   static_cast<double>(timer.loads[i]), greatest_of(timer.bits), "a faster clock would do");
  }
  return problems;
}

Problems problems_of(const InverseTimeRange& range) {
  Problems problems;
  check_positive(problems, {{"the travel", range.max_distance},
                            {"the BLU", range.blu},
                            {"the greatest feed", range.max_feed},
                            {"the resolution of the feed", range.resolution}});
  if (!problems.empty()) return problems;
  check_register(problems, "q", range.max_distance / range.blu, greatest_register - 1,
                 "a smaller travel or a larger BLU would do");
  check_register(problems, "q0 of the software", range.max_feed / range.resolution, greatest_register - 1,
                 "a coarser resolution would do");
  return problems;
}

Problems problems_of(const InverseTimeRange& range, double distance, double feed) {
  Problems problems;
  check_positive(problems, {{"the distance", distance}, {"the feed", feed}});
  if (!problems.empty()) return problems;
  const InverseTimeDesign design = design_inverse_time(range);
  check_register(problems, "q", distance / range.blu, static_cast<double>(design.capacity),
                 "design for a greater travel");
  check_feed(problems, feed, range.max_feed);
  const double word = inverse_time_word(range, distance, feed, false).word;
  check_word(problems, "f", word);
  check_word(problems, "f of the software", software_word(range, feed, false).word);
  check_register(problems, "f of " + std::to_string(range.digits) + " digits", std::round(word),
                 static_cast<double>(design.feed_capacity - 1),
                 "a lower feed, a longer distance or more digits would do");
  return problems;
}

}  // namespace leadscrew::design
