// Errors of lead screws in machine files: what is wrong with them is said with its place.

#include <gtest/gtest.h>

#include <ostream>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_screw_keys {

struct BadScrew {
  const char* name;
  std::string lines;
  Names problems;  ///< "line:column code"

  friend void PrintTo(const BadScrew& bad, std::ostream* stream) { *stream << bad.name; }
};

class RejectedScrew : public ::testing::TestWithParam<BadScrew> {};

TEST_P(RejectedScrew, IsNamedWithThePlaceOfItsEntry) {
  const Folder folder;
  folder.write("part.ngc", square);
  folder.write("m.toml", with_screw(GetParam().lines));
  const auto run = leadscrew(folder, {"run", "part.ngc", "--machine", "m.toml", "--pulses", "p.csv", "--json"});
  EXPECT_EQ(run.status, 3);
  const Names found = places_of(run.json()["diagnostics"]);
  EXPECT_EQ(found, GetParam().problems) << run.errors;
  EXPECT_EQ(folder.names(), (Names{"m.toml", "part.ngc"}));
}

INSTANTIATE_TEST_SUITE_P(
    Every, RejectedScrew,
    ::testing::Values(
        BadScrew{"NotFinite", "pitch_errors_mm = [[0, 0], [1, nan]]\n", {"12:28 pitch-value"}},
        BadScrew{"Order", "pitch_errors_mm = [\n  [0, 0],\n  [5, 0],\n  [4, 0],\n]\n", {"15:3 pitch-order"}},
        BadScrew{"Micrometres", "pitch_errors_mm = [[0, 0], [10, 12]]\n", {"12:28 pitch-slope"}},
        BadScrew{"Backward",
                 "pitch_errors_mm = [[0, 0]]\npitch_errors_backward_mm = [[0, 0], [0, 0]]\n",
                 {"13:37 pitch-order"}},
        BadScrew{"Backlash", "backlash_mm = -0.1\n", {"12:15 backlash"}},
        BadScrew{"Takeup", "backlash_takeup_mm_s = inf\n", {"12:24 backlash-takeup"}},
        BadScrew{"BacklashNoNumber", "backlash_mm = \"0.1\"\n", {"12:15 machine-type"}},
        BadScrew{"NoList", "pitch_errors_mm = \"x.comp\"\n", {"12:19 machine-type"}},
        BadScrew{"FlatList", "pitch_errors_mm = [0, 1]\n", {"12:20 machine-type", "12:23 machine-type"}},
        BadScrew{"Triples", "pitch_errors_mm = [[0, 0, 0.1]]\n", {"12:20 machine-type"}},
        BadScrew{"Misspelt", "pitch_error_mm = [[0, 0]]\n", {"12:1 machine-key"}},
        BadScrew{"KeyOfRotaryAxis", "backlash_deg = 0.1\n", {"12:1 machine-key"}},
        BadScrew{"Everything",
                 "pitch_errors_mm = [[0, 0], [0, 0], 7, [3, 0], [2, inf], [4, 0], [5, 1]]\n"
                 "pitch_errors_backward_mm = [[1, 0], [0, 0]]\nbacklash_mm = -1\nbacklash_takeup_mm_s = -1\n",
                 {"12:28 pitch-order", "12:36 machine-type", "12:47 pitch-value", "12:65 pitch-slope",
                  "13:37 pitch-order", "14:15 backlash", "15:24 backlash-takeup"}}),
    [](const auto& bad) { return std::string(bad.param.name); });

TEST(ScrewKeys, AreSuggested) {
  const Folder folder;
  folder.write("part.ngc", square);
  folder.write("m.toml", with_screw("pitch_error_mm = [[0, 0]]\nbacklash = 0.1\n"));
  const auto check = leadscrew(folder, {"check", "part.ngc", "--machine", "m.toml"});
  EXPECT_TRUE(contains(check.errors, "did you mean pitch_errors_mm?")) << check.errors;
  EXPECT_TRUE(contains(check.errors, "did you mean backlash_mm?")) << check.errors;
}

}  // namespace test_screw_keys
}  // namespace leadscrew::cli::testing
