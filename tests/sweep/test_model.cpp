// The model against what can be told without it, and what it reads of a sweep.

#include <gtest/gtest.h>

#include <algorithm>
#include <leadscrew/sweep/model.hpp>
#include <leadscrew/sweep/model_table.hpp>
#include <leadscrew/sweep/sensitivity.hpp>
#include <numeric>

#include "swept_archive.hpp"

namespace test_model {

using namespace leadscrew;
using sweep::ModelSetup;
using sweep::simulate;

constexpr ModelSetup ideal(int ranks, int processors) {
  return {.ranks = ranks, .processors = processors, .counter_service = 0, .counter_latency = 0, .shard_service = 0};
}

TEST(Model, OfOneRankTakesAllTasksOneAfterTheOther) {
  const std::vector<double> tasks = {3, 2, 1.5, 0.25};
  EXPECT_DOUBLE_EQ(simulate(ideal(1, 1), tasks).makespan, 6.75);
  const ModelSetup slow{
      .ranks = 1, .processors = 1, .counter_service = 0.5, .counter_latency = 0.25, .shard_service = 4};
  EXPECT_DOUBLE_EQ(simulate(slow, tasks).makespan, 4 * 0.75 + 6.75 + 4);
}

TEST(Model, GivesTheNextTaskToWhoIsFreeFirst) {
  const auto result = simulate(ideal(2, 2), {3, 2, 2, 1});  // 3 then 1; 2 then 2
  EXPECT_DOUBLE_EQ(result.makespan, 4);
  EXPECT_DOUBLE_EQ(result.efficiency, 1);
  EXPECT_DOUBLE_EQ(simulate(ideal(2, 2), {1, 1, 3}).makespan, 4);
  EXPECT_DOUBLE_EQ(simulate(ideal(2, 2), {1, 1, 3}).straggling, 3);
}

TEST(Model, SharesProcessorsEqually) {
  // Four at half speed until the first ends at 2, three at 2/3, and so on: the sum of work over two processors.
  EXPECT_NEAR(simulate(ideal(4, 2), {1, 1, 1, 1}).makespan, 2, 1e-12);
  EXPECT_NEAR(simulate(ideal(4, 2), {1, 2}).makespan, 2, 1e-12);
  EXPECT_NEAR(simulate(ideal(3, 1), {1, 2, 3}).makespan, 6, 1e-12);
}

TEST(Model, IsHeldByACounterThatIsTooSlow) {
  const std::vector<double> tasks(100'000, 1e-3);
  const ModelSetup setup{
      .ranks = 1000, .processors = 1000, .counter_service = 1e-5, .counter_latency = 0, .shard_service = 0};
  const auto result = simulate(setup, tasks);
  EXPECT_NEAR(result.makespan, 1.0, 0.02);  // 100 000 claims of 10 µs
  EXPECT_GT(result.counter_busy, 0.98);
}

TEST(Model, ReadsWhatASweepHasMeasured) {
  const cli::testing::Folder folder;
  folder.write("a.ngc", cli::testing::square);
  ASSERT_EQ(
      cli::testing::leadscrew(folder, {"sweep", "--programs", "a.ngc", "--jerk", "1,2,3,4", "--out", "out"}).status, 0);
  const auto table = cli::testing::leadscrew(folder, {"sweep", "--model", "1,4@2", "--out", "out"});
  EXPECT_EQ(table.status, 0) << table.errors;
  EXPECT_TRUE(cli::testing::contains(table.output, "4 tasks")) << table.output;
  EXPECT_EQ(cli::testing::leadscrew(folder, {"sweep", "--model", "0", "--out", "out"}).status, 2);
  EXPECT_EQ(cli::testing::leadscrew(folder, {"sweep", "--model", "1", "--out", "none"}).status, 3);
}

/// The model's time over the measured one, by the tasks' times of the clock: other work on the computer, and the other ranks of a
/// processor, are in them, so that each rank has a processor.
double modelled_over_measured(const cli::testing::Folder& folder, const std::string& out) {
  const auto shards = cli::testing::spent_of(folder, out);
  std::vector<cli::testing::SpentTime> all;
  for (const auto& tasks : shards) all.insert(all.end(), tasks.begin(), tasks.end());
  std::ranges::sort(all, {}, &cli::testing::SpentTime::begin);
  std::vector<double> tasks;
  double end = 0;
  for (const auto& task : all) {
    tasks.push_back(task.end - task.begin);
    end = std::max(end, task.end);
  }
  const int ranks = static_cast<int>(shards.size());
  return simulate({.ranks = ranks, .processors = ranks}, tasks).makespan / (end - all.front().begin);
}

TEST(LongModel, IsNearWhatIsMeasuredOnOneProcessTwoAndFour) {
  const cli::testing::Folder folder;
  std::vector<std::string> words = {"sweep", "--quiet"};
  cli::testing::add_long_programs(folder, 12, words);
  for (const char* const count : {"1", "2", "4"}) {
    auto all = words;
    all.insert(all.end(), {"--processes", count, "--out", count});
    ASSERT_EQ(cli::testing::leadscrew(folder, all).status, 0);
    EXPECT_NEAR(modelled_over_measured(folder, count), 1, 0.1) << count;
  }
}

#ifdef LEADSCREW_MPIRUN
TEST(LongModel, IsNearWhatIsMeasuredOnTwoRanksAndFour) {
  const cli::testing::Folder folder;
  std::vector<std::string> words = {"--quiet", "--out", "out"};
  cli::testing::add_long_programs(folder, 12, words);
  for (const char* const ranks : {"2", "4"}) {
    words[2] = ranks;
    ASSERT_EQ(cli::testing::ranked_sweep(folder, ranks, words).status, 0);
    EXPECT_NEAR(modelled_over_measured(folder, ranks), 1, 0.1) << ranks;
  }
}
#endif

TEST(Sensitivities, AreThoseOfASquareInClosedForm) {
  // Short sides from rest to rest at the limit of jerk take 4·cbrt(s/(2j)) each: −1/3 per cent for one per cent of jerk.
  const cli::testing::Folder folder;
  folder.write("short.ngc", "G21 G90 G61 F60000\nG1 X0.1\nX0\nM2\n");
  const auto outcome = cli::testing::leadscrew(
      folder, {"sweep", "--programs", "short.ngc", "--optimise", "--period", "10us", "--out", "out", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const auto all = outcome.json()["sensitivities"];
  ASSERT_EQ(all.size(), 10U);  // three orders of three axes, and the tolerance
  EXPECT_EQ(all[0]["limit"], "jerk X");
  EXPECT_NEAR(all[0]["elasticity"].get<double>(), -1.0 / 3, 2e-3);
  for (std::size_t k = 1; k < all.size(); ++k) EXPECT_NEAR(all[k]["elasticity"].get<double>(), 0, 1e-9) << all[k];
  EXPECT_TRUE(cli::testing::contains(folder.read("out/sensitivities.svg"), "jerk X"));
}

}  // namespace test_model
