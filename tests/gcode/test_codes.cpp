// What the table of codes says of words holds for every code in it.

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_codes {

TEST(CodeTable, AWordThatNothingTakesNamesTheCodesThatDo) {
  const struct {
    const char* word;
    const char* hint;
  } rows[] = {
      {"H1", "H belongs to G43"},
      {"I1", "I belongs to G2, G3, G5, G5.1, G73, G83, G87 and G10"},
      {"K1", "K belongs to G2, G3, G6.2, G73, G83 and G87"},
      {"L1", "L belongs to G5.2, G73, G74, G81, G82, G83, G84, G85, G86, G87, G88, G89, G10, M98 and G65"},
      {"P1",
       "P belongs to G2, G3, G5, G5.2, G6.2, G73, G74, G82, G83, G84, G86, G87, G88, G89, G4, G10, G64, M62, M63, M64, "
       "M65, M98, M99 and G65"},
      {"Q1", "Q belongs to G5, G73, G74, G83, G84, G87, G10, G64, M67 and M68"},
      {"E1", "E belongs to M67 and M68"},
      {"D1", "no supported code takes it"},
  };
  for (const auto& row : rows) {
    const Reading reading = read(std::string(row.word) + "\nM2\n");
    ASSERT_EQ(reading.problems(), "1:1 unused-word; ") << row.word;
    EXPECT_EQ(reading.diagnostics[0].hint, row.hint);
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
