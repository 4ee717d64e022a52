// What `run` says in words of feed and threads: of a program with a thread, with a tap, with neither.

#include <gtest/gtest.h>

#include <cstdio>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_thread_rows {

/// Behind the name of the row; empty where there is none.
std::string row(const std::string& text, const std::string& name) {
  const std::string begin = "\n  " + name + std::string(11 - name.size(), ' ');
  const std::size_t at = text.find(begin);
  if (at == std::string::npos) return "";
  const std::size_t from = at + begin.size();
  return text.substr(from, text.find('\n', from) - from);
}

struct Rows {
  std::string blocks, feed;
  std::string threads;  ///< up to the run-in, where there is one
  int run_in_line;
};

TEST(ThreadRows, TellFeedAndThreadsOfARun) {
  const Folder folder;
  folder.write("lathe.toml", machine_text() + "[spindle]\nacceleration_rpm_s = 2000\nnoise = 0.05\n");
  const std::string alone = "in step with the spindle alone, by S up to 300 mm/min";
  const std::string one = "1 line in step with the spindle", two = "2 lines in step with the spindle";
  const Rows all[] = {
      {"M3 S300\nG33 Z-10 K1\n", alone, one, 3},
      {"M3 S300\nG33 Z-10 K1\nG1 X5 F600\n", "programmed up to 600 mm/min, reached 100.0 % of it", one, 3},
      {"M3 S300\nG0 Z5\nG33.1 Z-10 K1\n", alone, two, 4},
      {"M3 S300\nG1 Z-10 F300\n", "programmed up to 300 mm/min, reached 100.0 % of it", "", 0},
      {"M3 S300\nG0 Z-10\n", "rapids only", "", 0},
  };
  for (const Rows& each : all) {
    SCOPED_TRACE(each.blocks);
    folder.write("part.ngc", "G21 G90 G94\n" + each.blocks + "M2\n");
    const auto told = leadscrew(folder, {"run", "part.ngc", "--machine", "lathe.toml"});
    EXPECT_EQ(told.status, 0) << told.errors;
    EXPECT_EQ(row(told.output, "feed"), each.feed);
    std::string threads = each.threads;
    if (each.run_in_line > 0) {
      const Json figures =
          leadscrew(folder, {"run", "part.ngc", "--machine", "lathe.toml", "--json"}).json()["threads"];
      char behind[80];
      std::snprintf(behind, sizeof behind, ", at the latest %.3f mm behind the beginning: line %d",
                    figures["run_in_mm"].get<double>(), each.run_in_line);
      threads += behind;
    }
    EXPECT_EQ(row(told.output, "threads"), threads);
  }
  // No thread is what ends before it is in step; nor is its way a run-in.
  folder.write("part.ngc", "G21 G90 G94\nM3 S1000\nG33 Z-3 K2\nG0 Z10\nG33 Z-40 K2\nM2\n");
  const auto told = leadscrew(folder, {"run", "part.ngc", "--machine", "lathe.toml"});
  const std::string threads = row(told.output, "threads");
  EXPECT_TRUE(threads.starts_with(one + ", at the latest ")) << threads;
  EXPECT_TRUE(threads.ends_with(" mm behind the beginning: line 5; 1 line too short to get in step: line 3"))
      << threads;
  const Json figures = leadscrew(folder, {"run", "part.ngc", "--machine", "lathe.toml", "--json"}).json()["threads"];
  EXPECT_EQ(figures["lines"], 1);
  EXPECT_EQ(figures["out_of_step"], 1);
  EXPECT_EQ(figures["out_of_step_line"], 3);
  EXPECT_GT(figures["run_in_mm"].get<double>(), 3);
  // Where nothing is simulated a thread goes by S, as feed does.
  folder.write("part.ngc", "G21 G90 G94\nM3 S300\nG33 Z-10 K1\nM2\n");
  const std::string plain = leadscrew(folder, {"run", "part.ngc"}).output;
  EXPECT_EQ(row(plain, "feed"), "programmed up to 300 mm/min, reached 100.0 % of it");
  EXPECT_EQ(row(plain, "threads"), "");
}

}  // namespace test_thread_rows
}  // namespace leadscrew::cli::testing
