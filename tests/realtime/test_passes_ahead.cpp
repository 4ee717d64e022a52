// Passes that a thread makes ahead are those that are made as they are asked for.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <leadscrew/realtime/passes_ahead.hpp>

namespace leadscrew::realtime {
namespace test_passes_ahead {

/// z = x y/100 over a square of 60 mm; a flat tool gouges nowhere and a large ball does.
surfaces::Machining saddle(double radius) {
  surfaces::SurfaceForm form;
  form.degree = {1, 1};
  form.knots = {std::vector<double>{0, 0, 1, 1}, std::vector<double>{0, 0, 1, 1}};
  form.count = {2, 2};
  for (const double y : {-30.0, 30.0}) {
    for (const double x : {-30.0, 30.0}) form.net.push_back({{x, y, x * y / 100}, 1});
  }
  surfaces::Machining machining;
  machining.surface = std::make_shared<const surfaces::Surface>(form);
  machining.cutter = {radius, radius};
  machining.u = machining.v = {0, 1};
  machining.scallop = 0.01;
  return machining;
}

void expect_same(const surfaces::Pass& found, const surfaces::Pass& expected) {
  ASSERT_EQ(found.nodes.size(), expected.nodes.size());
  EXPECT_EQ(found.number, expected.number);
  EXPECT_EQ(found.is_link, expected.is_link);
  for (std::size_t k = 0; k < found.nodes.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_EQ(found.nodes[k].tip[i].derivative, expected.nodes[k].tip[i].derivative);
  }
}

TEST(PassesAhead, AreThoseThatAreMadeAsTheyAreAskedFor) {
  surfaces::Passes ahead(saddle(5)), expected(saddle(5));
  std::atomic<double> seconds = 0;
  const auto source = passes_ahead(ahead, seconds);
  std::size_t count = 0;
  while (const auto pass = expected.next()) {
    const auto found = source->next();
    ASSERT_TRUE(found);
    expect_same(*found, *pass);
    ++count;
  }
  EXPECT_GT(count, 100u);
  EXPECT_FALSE(source->next());
  EXPECT_GT(seconds, 0);
  EXPECT_FALSE(source->next());
  EXPECT_FALSE(source->next());
  EXPECT_FALSE(ahead.failure());
  EXPECT_EQ(ahead.count(), expected.count());
}

TEST(PassesAhead, EndWithTheSameFailure) {
  surfaces::Passes ahead(saddle(150)), expected(saddle(150));
  std::atomic<double> seconds = 0;
  const auto source = passes_ahead(ahead, seconds);
  while (const auto pass = expected.next()) expect_same(source->next().value(), *pass);
  EXPECT_FALSE(source->next());
  ASSERT_TRUE(expected.failure() && ahead.failure());
  EXPECT_EQ(ahead.failure()->kind, surfaces::PassFailure::Kind::gouge);
  EXPECT_EQ(ahead.failure()->u, expected.failure()->u);
  EXPECT_EQ(ahead.count(), expected.count());
}

TEST(PassesAhead, AreNoLongerMadeOnceNobodyTakesThem) {
  std::size_t fewest = surfaces::most_passes;
  for (int taken = 0; taken < 20; ++taken) {
    surfaces::Passes passes(saddle(5));
    std::atomic<double> seconds = 0;
    {
      const auto source = passes_ahead(passes, seconds);
      for (int k = 0; k < taken % 5; ++k) EXPECT_TRUE(source->next());
    }
    EXPECT_GT(seconds, 0);
    fewest = std::min(fewest, passes.count());
  }
  EXPECT_LE(fewest, 2u);  // room is for eight passes and links
}

}  // namespace test_passes_ahead
}  // namespace leadscrew::realtime
