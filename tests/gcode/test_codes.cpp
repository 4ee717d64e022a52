// What the table of codes says of words holds for every code in it.

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_codes {

TEST(CodeTable, AWordThatNothingTakesNamesTheCodesThatDo) {
  // Those that no table will lose; others may join them.
  const struct {
    const char* word;
    std::vector<std::string> users;
  } rows[] = {
      {"H1", {"G43"}},
      {"I1", {"G2", "G3", "G5", "G5.1", "G87"}},
      {"K1", {"G2", "G3", "G6.2"}},
      {"L1", {"G5.2", "G81", "G83", "G10", "M98"}},
      {"P1", {"G2", "G5", "G6.2", "G82", "G4", "G10", "G64", "M62", "M65"}},
      {"Q1", {"G5", "G83", "G64", "M67", "M68"}},
      {"E1", {"M67", "M68"}},
  };
  for (const auto& row : rows) {
    const Reading reading = read(std::string(row.word) + "\nM2\n");
    ASSERT_EQ(reading.problems(), "1:1 unused-word; ") << row.word;
    const std::string& hint = reading.diagnostics[0].hint;
    EXPECT_TRUE(hint.starts_with(std::string(1, row.word[0]) + " belongs to ")) << hint;
    for (const std::string& user : row.users) {
      const std::size_t at = hint.find(" " + user);
      ASSERT_NE(at, std::string::npos) << hint << ": " << user;
      const char behind = at + 1 + user.size() < hint.size() ? hint[at + 1 + user.size()] : ' ';
      EXPECT_TRUE(behind == ',' || behind == ' ') << hint << ": " << user;
    }
  }
}

TEST(CodeTable, AWordThatTwoCodesTakeIsAmbiguous) {
  EXPECT_EQ(read("G4 P1 G64\nM2\n").problems(), "1:4 ambiguous-word; ");
  EXPECT_EQ(read("G64 Q0.1 G83 X1 Z-1 R1 F60\nM2\n").problems(), "1:5 ambiguous-word; ");
}

TEST(CodeTable, AMotionInForceIsRepeatedByItsOwnWords) {
  EXPECT_EQ(read_well("G0 X10\nG3 I-10 F60\nI-10\nM2\n").arcs().size(), 2u);
  EXPECT_EQ(read("G19 G3 J10 F60\nI-10\nM2\n").problems(), "2:1 unused-word; ");
  EXPECT_EQ(read("G1 X10 F60\nI-10\nM2\n").problems(), "2:1 unused-word; ");
}

}  // namespace test_codes
}  // namespace leadscrew::gcode
