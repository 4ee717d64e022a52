// feed.ripple of run and verify, measured from positions: along curves by each rule of parameter steps.

#include <gtest/gtest.h>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_feed_ripple {

double ripple_of(const Folder& folder, std::vector<std::string> words) {
  words.emplace_back("--json");
  const Json figures = leadscrew(folder, words).json();
  EXPECT_TRUE(figures["feed"]["ripple"].is_number()) << figures;
  return figures["feed"]["ripple"].is_number() ? figures["feed"]["ripple"].get<double>() : -1;
}

/// The feed errors of a cubic at 10 mm/s and 10 ms, by the chord: up to 33 % with uniform steps, 0.53 % with those of first
/// order, 0.016 % of second (Lin and Koren's rules; `study feed-fluctuation`). Curves are longer than their chords by
/// (VT κ)²/24: that much the chord that `newton` makes VT long falls short.
TEST(FeedRippleOfARun, HasTheSizesOfThePublishedRules) {
  const Folder folder;
  const auto ripple = [&](const std::string& rule) {
    return ripple_of(folder, {"run", "curve:plane-cubic", "--period", "10ms", "--interpolator", rule});
  };
  const double bend = 0.1 * 0.35522;  // VT κ where it bends most
  const double beyond_chord = bend * bend / 24;
  EXPECT_NEAR(ripple("uniform"), 0.33, 0.001);
  EXPECT_NEAR(ripple("taylor1"), 0.0053, beyond_chord);
  EXPECT_NEAR(ripple("taylor2"), 0.00016 + beyond_chord, 1e-5);
  EXPECT_NEAR(ripple("newton"), beyond_chord, 2e-6);
  EXPECT_LT(ripple("arc-length"), 1e-6);
}

TEST(FeedRippleOfARun, FallsFromRuleToRule) {
  const Folder folder;
  const std::string butterfly = source_folder / "examples/09-butterfly.ngc";
  const auto ripple = [&](const std::string& rule) {
    return ripple_of(folder, {"run", butterfly, "--interpolator", rule});
  };
  const double uniform = ripple("uniform"), taylor1 = ripple("taylor1"), taylor2 = ripple("taylor2"),
               arc_length = ripple("arc-length");
  EXPECT_GT(uniform, 0.1);
  EXPECT_GT(uniform, 20 * taylor1);
  EXPECT_GT(taylor1, 20 * taylor2);
  EXPECT_GT(taylor2, 1000 * arc_length);
}

TEST(FeedRippleOfATrace, IsThatOfItsRun) {
  const Folder folder;
  for (const std::string trace : {"t.csv", "t.npy"}) {
    const double of_run =
        ripple_of(folder, {"run", "curve:plane-cubic", "--interpolator", "taylor1", "--trace", trace});
    EXPECT_GT(of_run, 1e-4);
    EXPECT_EQ(ripple_of(folder, {"verify", trace, "curve:plane-cubic"}), of_run) << trace;
  }
}

/// Who does not tell the planned feed has none to depart from, and what another controller calls feed may be anything.
TEST(FeedRippleOfATrace, IsNullOfForeignOnes) {
  const Folder folder;
  folder.write("part.ngc", square);
  for (const std::string header : {"t,X,Y", "t,X,Y,feed"}) {
    std::string text = header + "\n";
    for (int n = 0; n < 9; ++n) text += std::to_string(n * 1e-3) + ",0,0" + (header.ends_with("d") ? ",600\n" : "\n");
    folder.write("t.csv", text);
    EXPECT_TRUE(leadscrew(folder, {"verify", "t.csv", "part.ngc", "--json"}).json()["feed"]["ripple"].is_null());
  }
}

}  // namespace test_feed_ripple
}  // namespace leadscrew::cli::testing
