#include <algorithm>
#include <array>
#include <cstdint>
#include <leadscrew/console/option_hints.hpp>

namespace leadscrew::console {

namespace {

struct OptionHint {
  enum class Place : std::uint8_t { behind, instead };  ///< of the hint that the problem has

  std::string_view code;
  Place place;
  std::string_view text;
};

using enum OptionHint::Place;

/// Every command that meets such a problem has the options that are named.
constexpr std::array<OptionHint, 19> option_hints = {{
    {"surface-gouge", behind, "--allow-gouge machines it all the same"},
    {"unknown-tool", behind, "--tools FILE gives the table"},
    {"no-tool-table", behind, "--tools FILE gives one"},
    {"travel", behind, "--machine FILE names another machine, --start where the program begins"},
    {"unknown-axis", behind, "--machine FILE names another machine"},
    {"servo-unstable", behind, "--period TIME sets the one, the machine file of --machine the others"},
    {"step-rate", behind, "--step-clock, --step-length and --step-space set the first two"},
    {"step-turn", behind, "--step-length, --direction-hold, --direction-setup and --step-clock set them"},
    {"pulse-velocity", instead,
     "program a lower feed, or give --accelerate: the feed then keeps to what the axes can do"},
    {"pulse-feed-word", instead, "program a higher feed, or give a slower --step-clock"},
    {"pulse-rate", instead, "program a lower feed, or give a faster --step-clock, up to 10MHz"},
    {"state-busy", behind, "--state FILE names it"},
    {"state-other", behind, "--state FILE names it"},
    {"resume-program", behind, "without --resume it begins there"},
    {"resume-ended", behind, "without --resume the program is driven again"},
    {"fuel-exhausted", behind, "--fuel BLOCKS allows more"},
    {"missing-sub", behind, "--subprograms DIR names further folders"},
    {"program-repeats", instead, "check and run take it once, drive goes on"},
    {"trace-period", behind, "--period TIME stands in place of what t says"},
}};

}  // namespace

base::Diagnostic with_options(base::Diagnostic problem) {
  const auto found = std::ranges::find(option_hints, problem.code, &OptionHint::code);
  const bool is_defect = problem.hint.starts_with("this is a defect");
  if (found == option_hints.end() || is_defect) return problem;
  const bool begins = found->place == instead || problem.hint.empty();
  problem.hint = begins ? std::string(found->text) : problem.hint + "; " + std::string(found->text);
  return problem;
}

}  // namespace leadscrew::console
