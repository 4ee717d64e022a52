// Ranks of MPI, by a program of their own (world/ranks.cpp).

#include <gtest/gtest.h>

#include "command.hpp"

#ifdef LEADSCREW_MPIRUN
namespace leadscrew::cli::testing {
namespace test_world {

const std::vector<std::string> over_a_network = {"--mca", "btl", "tcp,self", "--mca", "osc", "pt2pt"};

Outcome of_ranks(const char* ranks, const std::vector<std::string>& of_mpirun = {},
                 const std::vector<std::string>& more = {}) {
  const Folder folder;
  std::vector<std::string> words = of_mpirun;
  words.insert(words.end(), {"-n", ranks, "--oversubscribe", "--allow-run-as-root", LEADSCREW_RANKS});
  words.insert(words.end(), more.begin(), more.end());
  return leadscrew(folder, words, {.command = LEADSCREW_MPIRUN});
}

void expect_right(const Outcome& outcome, const char* ranks) {
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_TRUE(outcome.output.starts_with("gather 1\nbroadcast 1\nclaims 1\nthreads ")) << ranks << "\n"
                                                                                       << outcome.output;
}

int threads_of(const Outcome& outcome) {
  return std::stoi(outcome.output.substr(outcome.output.rfind(' ')));
}

TEST(World, GivesTextsOfAnySizeWholeAndClaimsOnce) {
  for (const char* const ranks : {"1", "5"}) {
    expect_right(of_ranks(ranks), ranks);
    expect_right(of_ranks(ranks, over_a_network), ranks);
  }
}

TEST(World, ServesClaimsByAThreadWhereMessagesCarryThoseOfAnyRank) {
  // MPI itself has threads, more of them over a network: those of one rank, which no other asks, are taken off.
  const auto more_threads = [](const std::vector<std::string>& of_mpirun, const std::vector<std::string>& more) {
    return threads_of(of_ranks("3", of_mpirun, more)) - threads_of(of_ranks("1", of_mpirun));
  };
  bool is_without = false;  // a rank that other work delays looks like one that is far
  for (int k = 0; k < 5 && !is_without; ++k) is_without = more_threads({}, {}) == 0;
  EXPECT_TRUE(is_without);
  EXPECT_EQ(more_threads({}, {"late"}), 1);
  EXPECT_EQ(more_threads(over_a_network, {}), 1);
}

TEST(World, EndsAllRanksWithTheStatusOfTheOneThatAborts) {
  EXPECT_EQ(of_ranks("3", {}, {"abort"}).status, 3);
  EXPECT_EQ(of_ranks("3", over_a_network, {"abort"}).status, 3);
}

}  // namespace test_world
}  // namespace leadscrew::cli::testing
#endif
