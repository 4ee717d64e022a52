// Most arcs are read on a shorter way than others: whatever a block asks for, what comes of it and what is said of it are
// the same as on the longer way, which P1 leads to.

#include <random>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_plain_arcs {

// Blocks of arcs and lines: right ones, nearly right ones, and wrong ones; around the middle of the travel or near its end.
class RandomArcs {
 public:
  explicit RandomArcs(std::uint64_t seed) : random_(seed) {}

  // The program, and the same with P1 in every arc.
  std::pair<std::string, std::string> programs() {
    std::string plain, longer;
    const auto add = [&](const std::string& line, bool is_arc) {
      plain += line + "\n";
      longer += line + (is_arc ? " P1\n" : "\n");
    };
    add(one_of({"G21", "G20", "G21 G18", "G20 G19", "G90.1", "G93", "G21"}), false);
    add("G1 X0 Y0 Z0 F100", false);
    add("G0 " + (pick(3) == 0 ? one_of({"X499 Y480", "Z495", "X10 Y20 Z-30"}) : ""), false);
    for (int i = 0; i < 12; ++i) {
      if (pick(5) == 0)
        add(one_of({"G91", "G90", "G1 X1 Y2", "G0 X0 Y0 Z0", "G81 R1 Z-1 X3", "G80", "G7", "G8"}), false);
      add(arc(), true);
    }
    return {plain + "M2\n", longer + "M2\n"};
  }

 private:
  int pick(int below) { return static_cast<int>(random_() % static_cast<unsigned>(below)); }
  std::string one_of(const std::vector<std::string>& texts) {
    return texts[static_cast<std::size_t>(pick(static_cast<int>(texts.size())))];
  }
  // Of few different values, so that arcs fit often.
  std::string word(char letter) { return letter + text((pick(5) - 2) * 5 + (pick(8) == 0 ? 0.01 : 0)); }

  std::string arc() {
    std::string block = one_of({"G2", "G3", "G3", "G3"});
    for (const char letter : {'X', 'Y', 'Z'}) {
      if (pick(3) != 0) block += word(letter);
    }
    if (pick(10) == 0) block += word('A');
    if (pick(3) == 0) {
      block += "R" + text(pick(12) - 3);
    } else {
      for (const char letter : {'I', 'J', 'K'}) {
        if (pick(letter == 'K' ? 6 : 3) != 0) block += word(letter);
      }
    }
    if (pick(3) == 0) block += "F" + text(pick(3) * 100);
    return block;
  }

  std::mt19937_64 random_;
};

std::string told(const Reading& reading) {
  std::string result;
  for (const Move& move : reading.moves) {
    result += text(static_cast<int>(move.kind)) + ": ";
    for (const double value : move.end) result += text(value) + " ";
    if (move.kind == Move::Kind::arc) {
      result += "about " + text(move.center_first) + " " + text(move.center_second) + " by " + text(move.turns) + " ";
    }
    result += "at " + text(move.feed.value) + "\n";
  }
  return result + reading.problems();
}

TEST(PlainArcs, AreReadAsOthersAre) {
  std::size_t arcs = 0, problems = 0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    const auto [plain, longer] = RandomArcs(seed).programs();
    const Reading reading = read(plain);
    ASSERT_EQ(told(reading), told(read(longer))) << "seed " << seed << "\n" << plain;
    arcs += reading.arcs().size();
    problems += static_cast<std::size_t>(reading.errors);
  }
  EXPECT_GT(arcs, 2000u);
  EXPECT_GT(problems, 2000u);
}

}  // namespace test_plain_arcs
}  // namespace leadscrew::gcode
