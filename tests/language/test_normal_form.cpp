// What `format` writes, and that its meaning is that of what it read.

#include <filesystem>
#include <fstream>
#include <leadscrew/language/normal_form.hpp>
#include <random>
#include <set>
#include <sstream>

#include "reading.hpp"

namespace leadscrew::language {
namespace test_normal_form {

namespace fs = std::filesystem;
using gcode::Dialect;

TEST(NormalForm, HasCapitalsBlanksAndShortNumbers) {
  EXPECT_EQ(normal_form("n0010g01x1.500y-.5z-0.00f0200.", Dialect::leadscrew), "N10 G1 X1.5 Y-0.5 Z0 F200");
  EXPECT_EQ(normal_form("  /G 0 X 1 0 . 5 ; there\r", Dialect::leadscrew), "/G0 X10.5 ; there");
  EXPECT_EQ(normal_form("g38.20x+5.", Dialect::leadscrew), "G38.2 X5");
  EXPECT_EQ(normal_form("G1 X[#1 + 2] Y#<a b>(in)Z-sin[30]", Dialect::leadscrew),
            "G1 X[#1 + 2] Y#<a b> (in) Z-sin[30]");
  EXPECT_EQ(normal_form("m3s100$ 0.", Dialect::linuxcnc), "M3 S100 $0");
  EXPECT_EQ(normal_form("g0@01^[30*2]", Dialect::linuxcnc), "G0 @1 ^[30*2]");
  EXPECT_EQ(normal_form("", Dialect::leadscrew), "");
  EXPECT_EQ(normal_form("%", Dialect::leadscrew), "%");
}

TEST(NormalForm, KeepsWhatItDoesNotKnow) {
  EXPECT_EQ(normal_form(" o<sub> call [1] [2]", Dialect::linuxcnc), "o<sub> call [1] [2]");
  EXPECT_EQ(normal_form("#1 = [2 + 3]", Dialect::linuxcnc), "#1 = [2 + 3]");
  EXPECT_EQ(normal_form("$J=G91 x1", Dialect::grbl), "$J=G91 x1");
  EXPECT_EQ(normal_form("G0 X1.2.3", Dialect::leadscrew), "G0 X1.2.3");
  EXPECT_EQ(normal_form("IF [#1 EQ 2] GOTO 10", Dialect::fanuc), "IF [#1 EQ 2] GOTO 10");
  EXPECT_EQ(normal_form("M117 hello g01", Dialect::marlin), "M117 hello g01");
}

// As what stands behind the program's end.
TEST(NormalForm, KeepsLettersWithoutNumbers) {
  EXPECT_EQ(normal_form("made by a post", gcode::Dialect::leadscrew), "made by a post");
}

TEST(NormalForm, KeepsPointsWhereTheyMatter) {
  EXPECT_EQ(normal_form("g04p2.0", Dialect::haas), "G4 P2.");
  EXPECT_EQ(normal_form("g04p200", Dialect::haas), "G4 P200");
  EXPECT_EQ(normal_form("g04p2.0", Dialect::linuxcnc), "G4 P2");
}

TEST(NormalForm, IsItsOwn) {
  for (const char* line :
       {"n0010g01x1.500y-.5", "G1 X[#1 + 2] (in)Z-.0", "/g0x1;a", "o1 if [1]", "#5=2 g1x1", "G28 X Y"}) {
    const std::string once = normal_form(line, Dialect::leadscrew);
    EXPECT_EQ(normal_form(once, Dialect::leadscrew), once);
  }
}

TEST(NormalForm, IsItsOwnWhateverTheText) {
  constexpr std::string_view alphabet = "GXMNO#<>[]()/%;*=+-. 0123456789abz@$\t\xff";
  std::mt19937 random(1980);
  for (int k = 0; k < 20'000; ++k) {
    std::string line;
    for (std::size_t length = random() % 30; line.size() < length;) line += alphabet[random() % alphabet.size()];
    for (const Dialect dialect : {Dialect::leadscrew, Dialect::fanuc, Dialect::marlin}) {
      const std::string once = normal_form(line, dialect);
      ASSERT_EQ(normal_form(once, dialect), once) << line;
    }
  }
}

TEST(NormalForm, TakesDeepTextsInBoundedTime) {
  for (const char* piece : {"#", "[", "SIN[", "ATAN[1]/", "(", "#<", "X-"}) {
    std::string line = "X";
    while (line.size() < 65'000) line += piece;
    EXPECT_GE(normal_form(line, Dialect::leadscrew).size(), 1u);
  }
}

bool is_same(const gcode::Move& a, const gcode::Move& b) {
  return a.kind == b.kind && a.line == b.line && a.start == b.start && a.end == b.end && a.feed.value == b.feed.value &&
         a.turns == b.turns && a.center_first == b.center_first && a.center_second == b.center_second &&
         a.dwell_seconds == b.dwell_seconds && a.event.kind == b.event.kind && a.event.value == b.event.value;
}

std::string normal_text(std::string_view text, Dialect dialect) {
  std::string result;
  while (!text.empty()) {
    const auto end = text.find('\n');
    result += normal_form(text.substr(0, end), dialect) + "\n";
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  }
  return result;
}

void keeps_its_meaning(const fs::path& path, Dialect dialect) {
  std::ostringstream file;
  file << std::ifstream(path).rdbuf();
  gcode::Conditions conditions;
  conditions.options.dialect = dialect;
  const gcode::Reading as_written = gcode::read(file.str(), conditions);
  const gcode::Reading formatted = gcode::read(normal_text(file.str(), dialect), conditions);
  EXPECT_EQ(as_written.errors, formatted.errors) << path;
  ASSERT_EQ(as_written.moves.size(), formatted.moves.size()) << path;
  for (std::size_t i = 0; i < as_written.moves.size(); ++i) {
    ASSERT_TRUE(is_same(as_written.moves[i], formatted.moves[i])) << path << ": move " << i;
  }
}

TEST(NormalForm, OfProgramsOfEveryDialectMeansTheSame) {
  int programs = 0;
  for (const auto& entry : fs::directory_iterator(LEADSCREW_SOURCE_DIR "/tests/programs/posts")) {
    const std::string name = entry.path().filename().string();
    keeps_its_meaning(entry.path(), *gcode::dialect_of(name.substr(0, name.find('-'))));
    ++programs;
  }
  EXPECT_GE(programs, 60);
  for (const auto& entry : fs::directory_iterator(LEADSCREW_SOURCE_DIR "/examples")) {
    if (entry.path().extension() == ".ngc") keeps_its_meaning(entry.path(), Dialect::leadscrew);
  }
}

}  // namespace test_normal_form
}  // namespace leadscrew::language
