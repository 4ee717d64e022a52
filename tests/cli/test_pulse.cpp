// `leadscrew pulse`: figures, conventions, paths, tables, pictures, and what it refuses.

#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/nc/pulse_method.hpp>

#include "quarter.hpp"

namespace leadscrew::cli::testing {
namespace test_pulse {

Names keys_of(const Json& object) {
  Names keys;
  for (const auto& [key, value] : object.items()) keys.insert(key);
  return keys;
}

TEST(Pulse, GivesTheFpgaTable) {
  const Folder folder;
  const Outcome outcome =
      leadscrew(folder, quarter({"--method", "point-comparison,dda,min-error,improved-min-error", "--json"}));
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.errors, "");
  const Json object = outcome.json();
  EXPECT_EQ(object["schema"], "leadscrew.pulse/1");
  struct Published {
    const char* method;
    int clocks, pulses;
    double error;
  };
  ASSERT_EQ(object["methods"].size(), 4u);
  std::size_t at = 0;
  for (const auto& [name, clocks, pulses, error] :
       {Published{"point-comparison", 10, 10, 0.877}, Published{"dda", 8, 7, 0.385},
        Published{"min-error", 7, 7, 0.385}, Published{"improved-min-error", 7, 7, 0.385}}) {
    const Json& method = object["methods"][at++];
    EXPECT_EQ(method["method"], name);
    EXPECT_EQ(method["clocks"], clocks) << name;
    EXPECT_EQ(method["pulses"], pulses) << name;
    EXPECT_NEAR(method["max_error_blu"], error, 5e-4) << name;
    EXPECT_EQ(method["end"], Json({0, 5})) << name;
    EXPECT_FALSE(method.contains("path"));
  }
}

TEST(Pulse, HasTheKeysOfTheContract) {
  const Folder folder;
  const Json object = leadscrew(folder, quarter({"--path", "--json"})).json();
  ASSERT_EQ(object["methods"].size(), nc::all_pulse_methods.size());
  for (const Json& method : object["methods"]) {
    EXPECT_EQ(keys_of(method), (Names{"method", "pulses", "clocks", "max_error_blu", "rms_error_blu", "worst", "end",
                                      "path", "options"}));
    double worst = 0, squares = 0;
    Json before = {5, 0};
    for (const Json& place : method["path"]) {
      const double x = place[0], y = place[1], error = std::abs(std::hypot(x, y) - 5);
      worst = std::max(worst, error);
      squares += error * error;
      EXPECT_LE(std::abs(x - before[0].get<double>()), 1);
      EXPECT_LE(std::abs(y - before[1].get<double>()), 1);
      EXPECT_NE(place, before);
      before = place;
    }
    EXPECT_EQ(method["path"].size(), method["pulses"]);
    EXPECT_EQ(method["path"].back(), method["end"]);
    EXPECT_NEAR(method["max_error_blu"], worst, 1e-12);
    EXPECT_NEAR(method["rms_error_blu"], std::sqrt(squares / method["pulses"].get<double>()), 1e-12);
  }
}

TEST(Pulse, NamesTheConventionsThatWereInForce) {
  const Folder folder;
  const auto options = [&](const Words& more) {
    Words words = more;
    words.push_back("--json");
    return leadscrew(folder, quarter(words)).json()["methods"][0]["options"];
  };
  EXPECT_EQ(options({"--method", "dda"}), Json({{"capacity", 5},
                                                {"preload", "half-lagging"},
                                                {"order", "parallel"},
                                                {"end_rule", "counters-by-quadrant-drained"}}));
  EXPECT_EQ(options({"--method", "dda", "--bits", "4", "--preload", "zero", "--order", "x-first"}),
            Json({{"bits", 4},
                  {"capacity", 16},
                  {"preload", "zero"},
                  {"order", "x-first"},
                  {"end_rule", "counters-by-quadrant-drained"}}));
  EXPECT_EQ(options({"--method", "dda", "--capacity", "12"}), Json({{"capacity", 12},
                                                                    {"preload", "half-lagging"},
                                                                    {"order", "parallel"},
                                                                    {"end_rule", "counters-by-quadrant-drained"}}));
  EXPECT_EQ(options({"--method", "koren", "--capacity", "12"})["capacity"], 12);
  EXPECT_EQ(options({"--method", "point-comparison", "--tie", "inward"})["tie"], "inward");
  EXPECT_EQ(options({"--method", "koren"})["order"], "x-first");
  EXPECT_EQ(options({"--method", "koren"})["preload"], "half");
}

/// Koren's hardware, 2 in long in steps of 0.0001 in: q of 12 in, so that a sixth of the commands give a step.
TEST(Pulse, HasRegistersOfFixedCapacity) {
  const Folder folder;
  const auto clocks = [&](const Words& curve) {
    Words words = {"pulse", "--method", "koren", "--capacity", "120000", "--preload", "zero", "--json"};
    words.insert(words.end(), curve.begin(), curve.end());
    return leadscrew(folder, words).json()["methods"][0]["clocks"].get<double>();
  };
  EXPECT_EQ(clocks({"--line", "--end", "20000,0"}), 120'000);
  // A turn, 2πq, and a clock or two of each quadrant, which waits for its counters.
  EXPECT_NEAR(clocks({"--arc", "--start", "10000,0", "--end", "10000,0"}), 753'982, 8);
}

/// With F = 0 inward, as its text has it, point comparison is 1 BLU off.
TEST(Pulse, ConventionsCount) {
  const Folder folder;
  const auto method = [&](const Words& more) {
    Words words = more;
    words.push_back("--json");
    return leadscrew(folder, quarter(words)).json()["methods"][0];
  };
  EXPECT_NEAR(method({"--method", "point-comparison", "--tie", "inward"})["max_error_blu"], 1, 1e-12);
  EXPECT_NEAR(method({"--method", "dda", "--preload", "half"})["max_error_blu"], 0.831, 5e-4);
  EXPECT_NEAR(method({"--method", "dda", "--preload", "half", "--order", "x-first"})["max_error_blu"], 0.657, 5e-4);
  EXPECT_GT(method({"--method", "dda", "--bits", "5"})["clocks"], 32);
}

TEST(Pulse, GoesAllTheWayRoundWhereItEndsAtItsStart) {
  const Folder folder;
  const Json object = leadscrew(folder, {"pulse", "--arc", "--start", "-7,3", "--end=-7,3", "--center", "-2,3", "--cw",
                                         "--json", "--method", "point-comparison"})
                          .json();
  EXPECT_EQ(object["methods"][0]["pulses"], 40);
  EXPECT_EQ(object["direction"], "cw");
}

TEST(Pulse, DrawsALineOf4BitsIn16Clocks) {
  const Folder folder;
  const Json object =
      leadscrew(folder, {"pulse", "--line", "--end", "-11,7", "--method", "dda,koren", "--bits", "4", "--json"}).json();
  EXPECT_EQ(object["shape"], "line");
  EXPECT_EQ(object["methods"][0]["clocks"], 16);
  EXPECT_EQ(object["methods"][1]["options"]["capacity"], 14);  // √170, rounded up
  EXPECT_EQ(object["methods"][1]["end"], Json({-11, 7}));
}

/// By dda and koren where nothing is said: a quarter of 12 by 7, whose integrands are taken 12·7 times.
TEST(Pulse, DrawsEllipses) {
  const Folder folder;
  const Words words = {"pulse", "--ellipse", "12,7", "--start", "-12,0", "--end", "0,7", "--cw", "--path", "--json"};
  const Json object = leadscrew(folder, words).json();
  EXPECT_EQ(object["shape"], "ellipse");
  EXPECT_EQ(object["semi_axes"], Json({12, 7}));
  ASSERT_EQ(object["methods"].size(), 2u);
  for (const Json& method : object["methods"]) {
    EXPECT_EQ(method["end"], Json({0, 7}));
    EXPECT_EQ(method["options"]["capacity"], 12);
    EXPECT_EQ(method["options"]["scale"], 84);
    double worst = 0;  // of the places, by the distance from 10 000 points of the ellipse
    for (const Json& place : method["path"]) {
      double least = 1e9;
      for (int i = 0; i <= 10'000; ++i) {
        const double angle = std::acos(-1.0) * i / 20'000;
        least = std::min(least, std::hypot(12 * std::cos(angle) + place[0].get<double>(),
                                           7 * std::sin(angle) - place[1].get<double>()));
      }
      worst = std::max(worst, least);
    }
    EXPECT_NEAR(method["max_error_blu"].get<double>(), worst, 1e-5);
  }
}

/// Koren's 10 001 BLU after half a period, by registers that are empty and by those that only overflow beyond q.
TEST(Pulse, RunsFreelyForTheClocksOfTheAngle) {
  const Folder folder;
  for (const char* preload : {"zero", "minus-one"}) {
    const Json method = leadscrew(folder, {"pulse", "--arc", "--start", "10000,0", "--end", "-10000,0", "--method",
                                           "koren", "--free", "--preload", preload, "--json"})
                            .json()["methods"][0];
    EXPECT_EQ(method["clocks"], 31'415);
    EXPECT_EQ(method["end"], Json({-10'001, 1}));
    EXPECT_EQ(method["options"]["end_rule"], "clocks-of-the-angle");
  }
}

// ---------------------------------------------------------------------------------------------------------------------

TEST(PulseText, ShowsEveryRegisterOfAShortCurve) {
  const Folder folder;
  const std::string text = leadscrew(folder, quarter({"--method", "dda"})).output;
  EXPECT_TRUE(contains(text, "0.385"));
  EXPECT_TRUE(contains(text, "  clock  dx  dy  x  y  rx  ry  nx  ny  q\n"));
  EXPECT_TRUE(contains(text, "      3  -1   1  4  3   0   0   4   2  5\n"));
  EXPECT_FALSE(contains(text, "\033["));
  EXPECT_TRUE(contains(leadscrew(folder, quarter({"--color", "always"})).output, "\033["));
  EXPECT_EQ(leadscrew(folder, quarter({"--quiet"})).output, "");
}

TEST(PulseText, ShowsTablesOfSeveralWhenAsked) {
  const Folder folder;
  const Words two = {"--method", "min-error,koren"};
  EXPECT_FALSE(contains(leadscrew(folder, quarter(two)).output, "clock  dx"));
  const std::string text = leadscrew(folder, quarter({two[0], two[1], "--table"})).output;
  EXPECT_TRUE(contains(text, "\nmin-error\n  clock  dx  dy  x  y  F  n1  n2  n3\n"));
  EXPECT_TRUE(contains(text, "\nkoren\n  clock  dx  dy  x  y  rx  ry  nx  ny  q\n"));
}

/// Beside the centre the table shows places as well as registers.
TEST(PulseText, ShowsPlacesWhereTheyAreNotTheRegisters) {
  const Folder folder;
  const std::string text = leadscrew(folder, {"pulse", "--arc", "--start", "15,0", "--end", "10,5", "--center", "10,0",
                                              "--method", "min-error"})
                               .output;
  EXPECT_TRUE(contains(text, "   X  Y  x  y  F  n1  n2  n3\n")) << text;
}

// ---------------------------------------------------------------------------------------------------------------------

using nc::PulseMethod;

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++count;
  return count;
}

TEST(PulsePicture, HasAPanelForEachMethod) {
  const Folder folder;
  EXPECT_EQ(leadscrew(folder, quarter({"--quiet", "--svg", "made.svg"})).status, 0);
  const std::string picture = folder.read("made.svg");
  EXPECT_EQ(picture.substr(0, 4), "<svg");
  EXPECT_TRUE(picture.ends_with("</svg>\n"));
  EXPECT_EQ(count_of(picture, "class=\"steps\""), nc::all_pulse_methods.size() + 1);  // and the legend's
  EXPECT_EQ(count_of(picture, "class=\"worst\""), nc::all_pulse_methods.size() + 1);
  for (const PulseMethod method : nc::all_pulse_methods)
    EXPECT_TRUE(contains(picture, ">" + std::string(nc::name(method)) + "<"));
  EXPECT_TRUE(contains(picture, "greatest error 0.8769 BLU, at (4, 1)"));
  EXPECT_TRUE(contains(picture, "prefers-color-scheme:dark"));
}

/// Ordinates of the true curve, from the top of its panel.
std::pair<double, double> extent_of_curve(const std::string& picture) {
  const std::string opening = "class=\"curve\" d=\"M";
  const std::size_t begin = picture.find(opening) + opening.size();
  std::istringstream places(picture.substr(begin, picture.find('"', begin) - begin));
  std::pair<double, double> extent{1e9, -1e9};
  for (std::string place; std::getline(places, place, 'L');) {
    const double down = std::stod(place.substr(place.find(' ')));
    extent = {std::min(extent.first, down), std::max(extent.second, down)};
  }
  return extent;
}

/// The worst place of a full circle may be beside its start: there is curve to both sides of it.
TEST(PulsePicture, ShowsACircleBeforeItsStartToo) {
  const Folder folder;
  for (const char* sense : {"--cw", "--ccw"}) {
    ASSERT_EQ(leadscrew(folder, {"pulse", "--arc", "--start", "300,0", "--end", "300,0", sense, "--method",
                                 "point-comparison", "--quiet", "--svg", "made.svg"})
                  .status,
              0);
    const std::string picture = folder.read("made.svg");
    EXPECT_TRUE(contains(picture, *(sense + 3) == 'w' ? "at (299, -1)" : "at (299, 1)")) << picture;
    // Panels lie between 50 and 390; the circle runs upwards through all of this one.
    const auto [top, bottom] = extent_of_curve(picture);
    EXPECT_LT(top, 50) << sense;
    EXPECT_GT(bottom, 390) << sense;
  }
}

/// Of a whole ellipse the curve is as high as its axis, and steps lie on it.
TEST(PulsePicture, HasTheEllipse) {
  const Folder folder;
  EXPECT_EQ(leadscrew(folder, {"pulse", "--ellipse", "16,8", "--start", "16,0", "--end", "16,0", "--quiet", "--method",
                               "koren", "--svg", "made.svg"})
                .status,
            0);
  const auto [top, bottom] = extent_of_curve(folder.read("made.svg"));
  EXPECT_NEAR(bottom - top, 16 * 340 / 34.0, 1);  // a panel of 340 shows 34 BLU
}

/// However long the path, what is shown is around its worst place.
TEST(PulsePicture, OfALargeCircleIsNoLarger) {
  const Folder folder;
  EXPECT_EQ(leadscrew(folder, {"pulse", "--arc", "--start", "100000,0", "--end", "100000,0", "--method", "koren",
                               "--quiet", "--svg", "made.svg"})
                .status,
            0);
  const std::string picture = folder.read("made.svg");
  EXPECT_LT(picture.size(), 20000u);
  EXPECT_TRUE(contains(picture, "around the worst place"));
}

// ---------------------------------------------------------------------------------------------------------------------

struct Misuse {
  Words arguments;
  const char* said;
};

TEST(PulseUsage, ErrorsSayWhatWasMeantAndDoNothing) {
  const Folder folder;
  for (const auto& [arguments, said] : {
           Misuse{{"pulse"}, "one of --arc, --line and --ellipse"},
           Misuse{{"pulse", "--arc", "--line", "--end", "1,1"}, "one of --arc, --line and --ellipse"},
           Misuse{{"pulse", "--arc", "--ellipse", "5,3", "--end", "1,1"}, "one of --arc, --line and --ellipse"},
           Misuse{{"pulse", "--ellipse", "5", "--end", "1,1"}, "--ellipse 5: needs two numbers"},
           Misuse{{"pulse", "--ellipse", "5,3", "--end", "1,1"}, "--start is missing"},
           Misuse{{"pulse", "--ellipse", "5,3", "--start", "5,0", "--end", "0,3", "--free"},
                  "--free is for arcs of circles by dda and koren"},
           Misuse{{"pulse", "--ellipse", "5,3", "--start", "5,0", "--end", "0,3", "--tie", "inward"},
                  "--tie is for arcs of circles by point-comparison"},
           Misuse{{"pulse", "--line", "--end", "5,3", "--free"}, "--free is for arcs by dda and koren"},
           Misuse{quarter({"--method", "dda", "--accumulation", "floor"}), "for arcs of circles that run freely"},
           Misuse{quarter({"--method", "dda", "--places", "17"}), "is not a whole number from 1 to 16"},
           Misuse{quarter({"--method", "dda", "--places", "4", "--bits", "6"}), "give no bits and no capacity beside"},
           Misuse{quarter({"--method", "koren", "--free", "--accumulation", "floor", "--preload", "minus-one"}),
                  "for magnitudes"},
           Misuse{quarter({"--method", "min-error", "--free"}), "--free is for arcs by dda and koren"},
           Misuse{{"pulse", "--arc", "--start", "5,0"}, "--end is missing"},
           Misuse{{"pulse", "--arc", "--end", "5,0"}, "--start is missing"},
           Misuse{{"pulse", "--line"}, "--end is missing"},
           Misuse{{"pulse", "--line", "--end", "5"}, "--end 5: needs two numbers"},
           Misuse{{"pulse", "--line", "--end", "5,1.5"}, "whole numbers of BLU"},
           Misuse{{"pulse", "--line", "--end", "5,1,2"}, "whole numbers of BLU"},
           Misuse{{"pulse", "--line", "--end", "5,1", "--center", "0,0"}, "--center is for arcs"},
           Misuse{{"pulse", "--line", "--end", "5,1", "--cw"}, "--cw is for arcs"},
           Misuse{quarter({"--cw"}), "an arc goes one way"},
           Misuse{quarter({"--method", "min-eror"}), "did you mean min-error?"},
           Misuse{quarter({"--method", "dda,dda"}), "dda is named twice"},
           Misuse{quarter({"--method", "dda,"}), "is none of point-comparison, dda"},
           Misuse{quarter({"--preload", "hlaf"}), "did you mean half?"},
           Misuse{quarter({"--tie", "inwards"}), "did you mean inward?"},
           Misuse{quarter({"--order", "y-first"}), "did you mean x-first?"},
           Misuse{quarter({"--bits", "0"}), "from 1 to 30"},
           Misuse{quarter({"--bits", "31"}), "from 1 to 30"},
           Misuse{quarter({"--bits", "8.5"}), "from 1 to 30"},
           Misuse{quarter({"--method", "min-error", "--preload", "half"}), "--preload is for dda and koren"},
           Misuse{quarter({"--method", "min-error", "--capacity", "9"}), "--capacity is for dda and koren"},
           Misuse{quarter({"--capacity", "9", "--bits", "4"}), "registers of N bits have the capacity 2^N"},
           Misuse{quarter({"--capacity", "0"}), "--capacity 0: is not a whole number from 1 to 1073741824"},
           Misuse{quarter({"--capacity", "1073741825"}), "from 1 to 1073741824"},
           Misuse{quarter({"--capacity", "1e5"}), "from 1 to 1073741824"},
           Misuse{quarter({"--method", "dda", "--tie", "inward"}), "--tie is for arcs by point-comparison"},
           Misuse{{"pulse", "--line", "--end", "5,1", "--order", "parallel"}, "--order is for arcs"},
           Misuse{quarter({"--path"}), "--path is for --json"},
           Misuse{quarter({"--table", "--json"}), "--table is text"},
           Misuse{quarter({"--metod", "dda"}), "did you mean --method?"},
           Misuse{quarter({"--machine", "mill3"}), "no option --machine"},
           Misuse{quarter({"--vcd", "made"}), "does not end in .vcd; the ending says the format"},
           Misuse{quarter({"--vcd", "made.svg"}), "does not end in .vcd; --svg is for .svg"},
           Misuse{quarter({"--svg", "made.vcd"}), "does not end in .svg; --vcd is for .vcd"},
           Misuse{quarter({"--vcd", "--quiet"}), "--vcd --quiet: is no file's name"},
           Misuse{quarter({"--svg", "-"}), "--svg -: is no file's name"},
           Misuse{quarter({"--svg", ""}), "--svg: the name of the file is empty"},
           Misuse{quarter({"--bits"}), "--bits needs a value: N"},
           Misuse{quarter({"--bits", "3", "--bits"}), "--bits needs a value: N"},
           Misuse{quarter({"--bits", "3", "--bits", "4"}), "--bits is given 2 times"},
           Misuse{quarter({"--bits", "3", "--bits", "--bits"}), "--bits is given 2 times"},
           Misuse{quarter({"--bits", "-3"}), "--bits -3: is not a whole number from 1 to 30"},
           Misuse{{"pulse", "--line", "--end", "99999999999999999999x,1"}, "whole numbers of BLU"},
           Misuse{{"pulse", "-", "--line", "--end", "3,4"}, "\"-\" is one word too many"},
           Misuse{{"puls"}, "did you mean pulse?"},
       }) {
    const Outcome outcome = leadscrew(folder, arguments);
    EXPECT_EQ(outcome.status, 2) << said;
    EXPECT_EQ(outcome.output, "") << said;
    EXPECT_TRUE(contains(outcome.errors, said)) << said << "\n" << outcome.errors;
    EXPECT_EQ(folder.names(), Names{}) << said;
  }
}

TEST(PulseRejection, NamesTheRegisterOrTheValue) {
  const Folder folder;
  for (const auto& [arguments, said] : {
           Misuse{{"pulse", "--arc", "--start", "5,0", "--end", "0,4"}, "[end-off-circle]"},
           Misuse{{"pulse", "--arc", "--start", "2,2", "--end", "2,5", "--center", "2,2"}, "[zero-radius]"},
           Misuse{{"pulse", "--ellipse", "0,3", "--start", "5,0", "--end", "0,3"}, "[zero-radius]"},
           Misuse{{"pulse", "--ellipse", "5,3", "--start", "5,0", "--end", "4,3"}, "[off-ellipse]"},
           Misuse{{"pulse", "--ellipse", "9,3", "--start", "9,0", "--end", "0,3", "--bits", "3"},
                  "4 bits would hold it"},
           Misuse{{"pulse", "--ellipse", "9,3", "--start", "9,0", "--end", "0,3", "--capacity", "8"},
                  "a capacity of 9 would do"},
           Misuse{{"pulse", "--ellipse", "1000000000,999999999", "--start", "1000000000,0", "--end", "1000000000,0"},
                  "more than registers hold"},
           Misuse{{"pulse", "--ellipse", "9,3", "--start", "9,0", "--end", "0,3", "--method", "koren,bresenham"},
                  "[no-ellipse]"},
           Misuse{{"pulse", "--line", "--start", "3,4", "--end", "3,4"}, "[no-way]"},
           Misuse{{"pulse", "--line", "--end", "256,1", "--bits", "8"}, "register Jx of 8 bits holds no more than 255"},
           Misuse{quarter({"--bits", "2"}), "register x of 2 bits holds no more than 3"},
           Misuse{{"pulse", "--line", "--end", "3,3", "--bits", "2", "--method", "koren"},
                  "the length, rounded up, is 5: register q of 2 bits holds no more than 3"},
           Misuse{quarter({"--capacity", "4"}),
                  "the radius, rounded, is 5: integrators of capacity 4 take no more than that [register-overflow]"},
           Misuse{{"pulse", "--line", "--end", "1,-9999999999"}, "y of the end is -9999999999: register y holds"},
           Misuse{{"pulse", "--line", "--end", "99999999999999999999,1"},
                  "x of the end is 99999999999999999999: register x holds no more than 1073741824 [register-overflow]"},
           Misuse{{"pulse", "--arc", "--start", "0,-9223372036854775809", "--end", "0,5"},
                  "y of the start is -9223372036854775809: register y holds"},
           Misuse{{"pulse", "--arc", "--start", "5,0", "--end", "0,5", "--center", "1073741825,0"},
                  "x of the centre is 1073741825: register x holds"},
       }) {
    Words words = arguments;
    words.insert(words.end(), {"--vcd", "made.vcd"});
    const Outcome outcome = leadscrew(folder, words);
    EXPECT_EQ(outcome.status, 3) << said;
    EXPECT_EQ(outcome.output, "") << said;
    EXPECT_TRUE(contains(outcome.errors, said)) << outcome.errors;
    words.push_back("--json");
    const Json object = leadscrew(folder, words).json();
    EXPECT_EQ(object["schema"], "leadscrew.pulse/1");
    EXPECT_EQ(object["methods"], Json::array());
    EXPECT_GE(object["diagnostics"].size(), 1u);
    EXPECT_EQ(folder.names(), Names{}) << said;
  }
}

/// Whether 64 bits would hold them or not.
TEST(PulseRejection, NamesEveryCoordinate) {
  const Folder folder;
  const Words words = {"pulse", "--arc",    "--start",         "18446744073709551616,-1073741825",
                       "--end", "0,1e6",    "--center",        "-1073741824,1073741824",
                       "--cw",  "--method", "min-error,koren", "--json"};
  EXPECT_EQ(leadscrew(folder, words).status, 2);
  Words whole = words;
  whole[5] = "-18446744073709551617,0";
  const Outcome outcome = leadscrew(folder, whole);
  EXPECT_EQ(outcome.status, 3);
  const Json diagnostics = outcome.json()["diagnostics"];
  Names said;
  for (const Json& problem : diagnostics) {
    const std::string message = problem["message"];
    said.insert(message.substr(0, message.find(':')));
  }
  EXPECT_EQ(said, (Names{"x of the start is 18446744073709551616", "y of the start is -1073741825",
                         "x of the end is -18446744073709551617"}));
}

/// Names may stand apart, and an option that is far from all others is not taken for one of them.
TEST(PulseUsage, TakesNamesAsTheyAreWritten) {
  const Folder folder;
  const Json object = leadscrew(folder, quarter({"--method", "dda, koren", "--json"})).json();
  EXPECT_EQ(object["methods"].size(), 2u);
  const Outcome outcome = leadscrew(folder, quarter({"--feed", "100"}));
  EXPECT_EQ(outcome.status, 2);
  EXPECT_TRUE(contains(outcome.errors, "no option --feed\n")) << outcome.errors;
}

TEST(PulseFiles, ThatCannotBeWrittenAreNotThere) {
  const Folder folder;
  folder.write("none", "");
  const Outcome outcome = leadscrew(folder, quarter({"--vcd", "made.vcd", "--svg", "none/made.svg"}));
  EXPECT_EQ(outcome.status, 4);
  EXPECT_TRUE(contains(outcome.errors, "none: error: cannot make the folder: Not a directory [io-open]\n"))
      << outcome.errors;
  EXPECT_EQ(folder.names(), Names{"none"});
  EXPECT_EQ(leadscrew(folder, quarter({"--vcd", "/dev/full"})).status, 4);
}

/// Some 5·10⁹ clocks: it would take half a minute.
TEST(PulseInterrupt, EndsALongRun) {
  const Folder folder;
  Running running(folder, {"pulse", "--arc", "--start", "1073741824,0", "--end", "1073741824,0", "--vcd", "made.vcd"});
  ASSERT_TRUE(eventually([&] { return running.handles(SIGINT); }));
  running.send(SIGINT);
  EXPECT_EQ(running.wait().status, 130);
  EXPECT_EQ(folder.names(), Names{});
}

TEST(Pulse, HelpShowsExamples) {
  const Folder folder;
  const Outcome outcome = leadscrew(folder, {"pulse", "--help"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_TRUE(contains(outcome.output, "leadscrew pulse --arc --start 5,0 --end 0,5"));
  EXPECT_TRUE(contains(outcome.output, "point-comparison, dda, min-error, improved-min-error, bresenham, koren"));
}

}  // namespace test_pulse
}  // namespace leadscrew::cli::testing
