// The study of a surface in one block: its figures, and its own checks against closed forms.

#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/study/studies.hpp>
#include <leadscrew/study/surface_patch.hpp>
#include <string>

#include "found.hpp"

namespace test_surface_study {

using namespace leadscrew;
using namespace leadscrew::study;
using leadscrew::study::testing::ours;

const std::string head = "patch of 60 by 60 mm, ball of 5 mm radius, ridges of 0.01 mm: ";

const Rows& rows() {
  static const Rows all = surface_rows({});
  return all;
}

TEST(SurfaceStudy, ComesOut) {
  EXPECT_GE(rows().size(), 35u);
  for (const Row& row : rows()) {
    if (row.what == "a word of a surface, median") continue;  // without a clock
    const bool good = row.verdict == Verdict::exact || row.verdict == Verdict::reproduced ||
                      row.verdict == Verdict::kept || row.verdict == Verdict::measured ||
                      row.verdict == Verdict::no_worse ||
                      (row.verdict == Verdict::not_run && row.group.ends_with("the cycle, five axes"));
    EXPECT_TRUE(good) << row.group << ": " << row.what << ' ' << row.ours.value_or(NAN) << ' ' << row.why;
  }
}

TEST(SurfaceStudy, PublishesWhatThePaperSaysAlone) {
  for (const Row& row : rows()) {
    if (!row.published) continue;
    EXPECT_TRUE(row.published->value == 1 || row.published->value == 2) << row.what;
  }
}

/// A stop at each line costs two to six times the time; blended, lines take as long as the surface, but for their tolerance.
TEST(SurfaceStudy, StopsCostManyTimesTheTime) {
  const std::string times = head + "times, 50 mm/s at the tip";
  const double block = ours(rows(), times, "one block");
  EXPECT_GE(ours(rows(), times, "lines within 0.010 mm, a stop at each"), 2.5 * block);
  EXPECT_GE(ours(rows(), times, "lines within 0.001 mm, a stop at each"), 5.5 * block);
  EXPECT_NEAR(ours(rows(), times, "lines within 0.001 mm, blended"), block, 0.03 * block);
}

TEST(SurfaceStudy, OneBlockIsExactAndSmall) {
  EXPECT_LE(ours(rows(), head + "accuracy", "one block: ball off the surface"), 1e-6);
  EXPECT_GE(ours(rows(), head + "accuracy", "highest ridge"), 9.99);
  const std::string size = head + "size of the program";
  EXPECT_GE(ours(rows(), size, "lines within 0.010 mm, links too"), 300 * ours(rows(), size, "one surface"));
}

/// A ball's centre above a place of the patch, by its radius and something along the normal.
TEST(SurfacePatch, TellsHowFarABallIsFromTouching) {
  const surfaces::Surface surface(patch_form());
  const Vector n = {-0.0691203, 0.21155002, 0.97491998};  // at (15, 45, 3.260742)
  for (const double off : {0.0, 1e-3, 0.25}) {
    const Vector tip = {15 + (ball_radius + off) * n[0], 45 + (ball_radius + off) * n[1],
                        3.260742 + (ball_radius + off) * n[2] - ball_radius};
    EXPECT_NEAR(contact_error(surface, tip), off, 1e-6);
  }
}

/// Chords of a circle: nobody needs more than their number by the sagitta.
TEST(SurfacePatch, LinesAreAsLongAsTheirTolerance) {
  const auto passes = patch_passes();
  const LinesOfPasses lines = lines_of(passes, 0.01);
  ASSERT_GE(lines.ends.size(), lines.of_passes);
  EXPECT_EQ(lines.ends.size() - 1 > lines.of_passes, true);  // links have lines too
  const Vector first = place_of(passes[0], passes[0].nodes.front().t);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(lines.ends.front()[k], first[k]);
}

}  // namespace test_surface_study
