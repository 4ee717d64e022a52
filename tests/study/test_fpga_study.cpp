// The FPGA paper's table, by the rows of its study.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <leadscrew/study/fpga_cells.hpp>
#include <leadscrew/study/studies.hpp>
#include <sstream>
#include <string>

#include "found.hpp"

namespace leadscrew::study::testing {
namespace test_fpga_study {

/// Both conventions of the DDA were chosen for the table's figures; each makes 7 pulses in 8 clocks.
TEST(FpgaTable1Study, ComesOut) {
  const Rows rows = fpga_rows({});
  for (const Row& row : rows) {
    const bool is_dda = row.group.starts_with("DDA");
    const Verdict told = !row.published                                           ? Verdict::measured
                         : row.what == "logic elements"                           ? Verdict::not_reproducible
                         : row.what == "pulses" || row.what == "DDA, of all four" ? Verdict::differs
                         : is_dda                                                 ? Verdict::fitted
                                                                                  : Verdict::exact;
    EXPECT_EQ(row.verdict, told) << row.group << ": " << row.what;
  }
  EXPECT_EQ(rows.size(), 27u);
  for (const char* group : {"DDA", "DDA, growing axis first"}) {
    EXPECT_EQ(ours(rows, group, "steps"), 8) << group;
    EXPECT_EQ(ours(rows, group, "pulses"), 7) << group;
    EXPECT_EQ(published(found(rows, group, "pulses")), 8) << group;
    EXPECT_NEAR(ours(rows, group, "greatest error"), 0.385, 5e-4) << group;
  }
  constexpr const char* others = "greatest error by other conventions";
  EXPECT_NEAR(ours(rows, others, "point comparison, F = 0 inward"), 1, 1e-12);
  EXPECT_NEAR(ours(rows, others, "DDA, both axes half full"), 0.831, 5e-4);
  EXPECT_NEAR(ours(rows, others, "DDA, both half full, x first"), 0.657, 5e-4);
}

/// Sizes of our hardware are those that synthesis has found.
TEST(FpgaTable1Study, HasTheCellsOfTheSynthesisReport) {
  std::ifstream report(LEADSCREW_SOURCE_DIR "/hdl/syn/table_1.txt");
  const std::array all = {point_comparison_cells, dda_cells, least_error_cells, improved_least_error_cells};
  std::size_t count = 0;
  for (std::string line; std::getline(report, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream words(line);
    std::string module;
    int logic = 0, flip_flops = 0;
    ASSERT_TRUE(words >> module >> logic >> flip_flops) << line;
    const auto cells = std::ranges::find_if(all, [&](const FpgaCells& each) { return each.module == module; });
    ASSERT_NE(cells, all.end()) << module;
    EXPECT_EQ(cells->logic, logic) << module;
    EXPECT_EQ(cells->flip_flops, flip_flops) << module;
    ++count;
  }
  EXPECT_EQ(count, all.size());
}

}  // namespace test_fpga_study
}  // namespace leadscrew::study::testing
