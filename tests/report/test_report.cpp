#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/report/report.hpp>
#include <set>

#include "byte_sinks.hpp"

namespace leadscrew::report {
namespace test_report {

using namespace testing_support;

/// Every element is closed in order, nothing but known references follows an ampersand; says what is wrong.
std::string wrong_markup(const std::string& page) {
  const std::set<std::string> void_elements{"meta", "!DOCTYPE", "br"};
  std::vector<std::string> open;
  for (std::size_t at = 0; at < page.size(); ++at) {
    if (page[at] == '&') {
      const std::string name = page.substr(at, page.find(';', at) - at + 1);
      if (!std::set<std::string>{"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"}.contains(name)) return "reference " + name;
    }
    if (page[at] != '<') continue;
    const std::size_t end = page.find('>', at);
    if (end == std::string::npos) return "open end";
    const std::string tag = page.substr(at + 1, end - at - 1);
    const std::string name = tag.substr(tag.starts_with('/'), tag.find_first_of(" \n/", 1) - tag.starts_with('/'));
    at = end;
    if (tag.starts_with('/')) {
      if (open.empty() || open.back() != tag.substr(1))
        return "closes " + tag + " in " + (open.empty() ? "" : open.back());
      open.pop_back();
    } else if (!tag.ends_with('/') && !void_elements.contains(name)) {
      open.push_back(name);
    }
    if (!tag.starts_with('/') && (name == "script" || name == "style")) at = page.find("</" + name, at) - 1;
  }
  return open.empty() ? "" : "leaves open " + open.back();
}

base::Diagnostic diagnostic(base::Severity severity, std::string_view code, const std::string& text,
                            const std::string& file, std::int64_t line, std::int64_t column) {
  base::Diagnostic made;
  made.severity = severity;
  made.code = code;
  made.message = "message " + text;
  made.hint = "hint " + text;
  made.source = text;
  made.place.file = file;
  made.place.line = line;
  made.place.column = column;
  return made;
}

struct Recorded {
  machine::Machine machine = machine::mill3();
  Recording recording{machine, millisecond};
  Report report;

  explicit Recorded(const std::vector<base::Word>& words) {
    for (const base::Word& word : words) recording.observe(word);
    report.title = "part.ngc";
    report.version = "9.8.7";
    report.command = "leadscrew run part.ngc --report r.html";
    report.time_s = recording.seconds();
    report.tolerance_mm = 0.01;
    report.limits = {{base::Axis::X, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5}};
  }

  std::string page() const {
    std::string text;
    EXPECT_TRUE(write_report(report, recording, machine, millisecond, into(text)));
    return text;
  }

  std::string picture() const {
    std::string text;
    EXPECT_TRUE(write_path_svg(report.title, recording, into(text)));
    return text;
  }
};

bool has(const std::string& page, std::string_view text) {
  return page.find(text) != std::string::npos;
}

TEST(Report, SaysWhatItMust) {
  Recorded run(random_train(5000, 2));
  run.report.source = {{run.recording.slowest_blocks()[0].line, "N10 G1 X5 (rough)"}};
  run.report.diagnostics.push_back(diagnostic(base::Severity::warning, "feed-missing", "no feed", "part.ngc", 3, 2));
  const std::string page = run.page();
  EXPECT_EQ(wrong_markup(page), "");
  for (const char* text : {"part.ngc",     "Keeps every limit",
                           "9.8.7",        "leadscrew run part.ngc --report r.html",
                           "4.999 s",      "Top",
                           "Front",        "Right side",
                           "Isometric",    "mm/min",
                           "Axis X",       "Axis Y",
                           "Axis Z",       "velocity",
                           "acceleration", "jerk",
                           "limit 200",    "N10 G1 X5 (rough)",
                           "part.ngc:3:2", "[feed-missing]",
                           "hint no feed", "mill3",
                           "color-scheme", "prefers-color-scheme:dark",
                           "@media print"}) {
    EXPECT_TRUE(has(page, text)) << text;
  }
}

TEST(Report, NeedsNothingFromOutside) {
  const std::string page = Recorded(random_train(500, 2)).page();
  for (const char* text : {"http:", "https:", "src=", "@import", "url(", "<link", "<iframe"})
    EXPECT_FALSE(has(page, text)) << text;
}

TEST(Report, VerdictNamesWhatIsExceeded) {
  Recorded run(random_train(500, 2));
  run.report.limits[0].jerk = 1.25;
  EXPECT_TRUE(has(run.page(), "Exceeds the jerk limit of axis X by 25 %"));
  EXPECT_FALSE(has(run.page(), "Keeps every limit"));
  run.report.limits[0].jerk = 1.0009;
  EXPECT_TRUE(has(run.page(), "Keeps every limit"));
  run.report.limits[0].planned_velocity = 1.1;
  EXPECT_TRUE(has(run.page(), "in the plan alone"));
  run.report.limits[0].planned_velocity = 0;
  run.report.deviation_mm = 0.015;
  EXPECT_TRUE(has(run.page(), "Leaves the programmed path by 15 µm; 10 µm is allowed"));
  run.report.deviation_mm = 0;
  run.report.feed_max_ratio = 1.02;
  EXPECT_TRUE(has(run.page(), "Exceeds the programmed feed by 2 %"));
  run.report.feed_max_ratio = 1;
  run.report.diagnostics.push_back(diagnostic(base::Severity::error, "x", "", "", 0, 0));
  EXPECT_TRUE(has(run.page(), "Has an error"));
}

TEST(Report, VerdictNamesAnAxisThatLeavesItsTravel) {
  auto words = random_train(500, 2);
  for (base::Word& word : words) word.position[2] += 1000;
  EXPECT_TRUE(has(Recorded(words).page(), "Leaves the travel of axis Z"));
}

TEST(Report, ForeignTextCannotBecomeMarkup) {
  const std::string evil = "<script>alert('x')</script>&\"\xff\x01</title></style>-->";
  Recorded run(random_train(500, 2));
  run.machine.name = evil;
  run.report.title = run.report.version = run.report.command = evil;
  for (const BlockFigures& block : run.recording.slowest_blocks()) run.report.source.emplace_back(block.line, evil);
  run.report.diagnostics.push_back(diagnostic(base::Severity::error, "bad", evil, evil, 1, 9));
  EXPECT_EQ(wrong_markup(run.page()), "");
  EXPECT_FALSE(has(run.page(), "<script>alert"));
  EXPECT_FALSE(has(run.page(), "\xff"));
  EXPECT_TRUE(has(run.page(), "&lt;script&gt;alert(&#39;x&#39;)"));
  EXPECT_EQ(wrong_markup(run.picture()), "");
  EXPECT_FALSE(has(run.picture(), "<script>"));
  EXPECT_FALSE(has(run.picture(), "\xff"));
}

TEST(Report, RecordingsOfNothingMakeASanePage) {
  for (const std::size_t count : {0, 1, 2, 5000}) {
    const std::vector<base::Word> at_rest(count);
    Recorded run(at_rest);
    run.report.deviation_mm = NAN;
    const std::string page = run.page(), picture = run.picture();
    EXPECT_EQ(wrong_markup(page), "");
    EXPECT_EQ(wrong_markup(picture), "");
    for (const char* text : {"nan", "inf\""}) {
      EXPECT_FALSE(has(page, text)) << text;
      EXPECT_FALSE(has(picture, text)) << text;
    }
    EXPECT_EQ(has(page, "Nothing moves"), count < 2) << count;
  }
}

TEST(Report, MachinesWithoutLinearAxesAndWithNineHaveAPage) {
  for (const bool all : {false, true}) {
    machine::Machine machine = machine::mill3();
    for (const base::Axis axis : base::all_axes) {
      machine.axes[base::index(axis)].reset();
      if (all || base::is_rotary(axis))
        machine.axes[base::index(axis)] = machine::AxisLimits{-99, 99, 200, 1000, 20000, 0.001};
    }
    Recording recording(machine, millisecond);
    for (const base::Word& word : random_train(6000, 8)) recording.observe(word);
    std::string page;
    ASSERT_TRUE(write_report({}, recording, machine, millisecond, into(page)));
    EXPECT_EQ(wrong_markup(page), "");
    EXPECT_TRUE(has(page, "°/s²"));
    EXPECT_LT(page.size(), 5'000'000u);
  }
}

TEST(Report, TenMillionWordsMakeLessThanFiveMegabytes) {
  machine::Machine machine = machine::mill3();
  for (auto& axis : machine.axes) axis = machine::AxisLimits{-1e6, 1e6, 200, 1000, 20000, 0.001};
  Recording recording(machine, millisecond);
  auto words = random_train(100000, 5, 2);
  std::int64_t tick = 0;
  for (int round = 0; round < 100; ++round) {
    for (base::Word word : words) {
      word.tick = base::Tick{tick++};
      word.position[0] += round * 0.1;
      recording.observe(word);
    }
  }
  EXPECT_LE(recording.path().size(), 20000u);
  EXPECT_LE(recording.feed().size(), 4096u);
  Report report;
  report.diagnostics.resize(100000);
  for (base::Diagnostic& diagnostic : report.diagnostics) {
    diagnostic.message = diagnostic.hint = diagnostic.source = std::string(5000, '<');
  }
  report.title = report.command = std::string(1'000'000, '&');
  std::string page, picture;
  ASSERT_TRUE(write_report(report, recording, machine, millisecond, into(page)));
  ASSERT_TRUE(write_path_svg("long", recording, into(picture)));
  EXPECT_LT(page.size(), 5'000'000u);
  EXPECT_LT(picture.size(), 300'000u);
  EXPECT_EQ(wrong_markup(page), "");
  EXPECT_EQ(wrong_markup(picture), "");
}

/// 0 to 100 mm: `feed` mm/s but for a rapid of 200 mm/s in the middle third, told by events if `tells`.
Recorded with_rapid(double feed, bool tells) {
  const auto enters = [](std::int64_t tick, double value) {
    return base::PassedEvent{{base::Event::Kind::programmed_feed, value, base::Line{1}, 0, false}, base::Tick{tick}, 0};
  };
  Recorded run({});
  for (std::int64_t i = 0; i < 100; ++i) {
    if (tells && i == 0) run.recording.observe(enters(0, feed));
    if (tells && i == 30) run.recording.observe(enters(33, 0));  // three words before it happens
    if (tells && i == 60) run.recording.observe(enters(66, feed));
    base::Word word;
    word.tick = base::Tick{i};
    word.position = {static_cast<double>(i), i < 50 ? 0.0 : 1.0, 0};
    word.feed = 33 <= i && i < 66 ? 200 : feed;
    run.recording.observe(word);
  }
  return run;
}

/// Thin and dashed, and the scale of colours is that of feed moves.
TEST(Report, DrawsRapidsApart) {
  const Recorded run = with_rapid(10, true);
  EXPECT_EQ(run.recording.greatest_feed(), 10);
  EXPECT_EQ(run.recording.greatest_rapid(), 200);
  for (const PathPoint& point : run.recording.path())
    EXPECT_EQ(point.is_rapid, 32.5 < point.position[0] && point.position[0] < 65.5) << point.position[0];
  EXPECT_EQ(wrong_markup(run.page()), "");
  EXPECT_TRUE(has(run.picture(), ">600 mm/min</text>"));
  EXPECT_TRUE(has(run.picture(), ">rapids</text>"));
  EXPECT_TRUE(has(run.picture(), "<path class=\"rapid\" stroke-width=\"8.4\""));
  EXPECT_TRUE(has(run.page(), "Speed of feed moves"));
  EXPECT_TRUE(has(run.page(), "peak 600; rapids up to 12\u202f000"));
  const Recorded all = with_rapid(10, false);
  EXPECT_FALSE(has(all.picture(), "rapid\" s"));
  EXPECT_FALSE(has(all.picture(), ">rapids<"));
  EXPECT_TRUE(has(all.picture(), ">12\u202f000 mm/min</text>"));
}

TEST(Report, OfRapidsAloneHasNoColours) {
  const Recorded run = with_rapid(0, true);
  EXPECT_FALSE(has(run.picture(), "mm/min"));
  EXPECT_TRUE(has(run.picture(), ">rapids</text>"));
  EXPECT_FALSE(has(run.page(), "<div class=\"bar\""));
  EXPECT_EQ(wrong_markup(run.page()), "");
}

/// Causes as they are given, the eleven blocks by what they lose, ten of them marked in each of the four pictures.
TEST(Report, ShowsWhereTimeIsLost) {
  Recorded run(random_train(500, 2));
  EXPECT_FALSE(has(run.page(), "Where time is lost"));
  run.report.time_s = 100;
  run.report.losses = {{"acceleration Z", 40}, {"jerk X", 10}, {"chord", 0.001}};
  for (int i = 1; i <= 11; ++i) {
    const double asked = i == 11 ? HUGE_VAL : 20;
    run.recording.observe(LostBlock{base::Line{i}, asked, 5, 9, 1.0 * i, "acceleration Z", {1.0 * i, 0, 0}});
  }
  run.report.source = {{base::Line{11}, "G0 X99 (far)"}, {base::Line{2}, "G1 X2"}, {base::Line{1}, "G1 X1 (cheap)"}};
  const std::string page = run.page();
  EXPECT_EQ(wrong_markup(page), "");
  EXPECT_TRUE(has(page, "50.001 s (50 %) are more than feed words ask"));
  EXPECT_TRUE(has(page,
                  "acceleration of Z</td><td class=\"share\"><i style=\"width:100%\"></i></td><td>40.000 s</td>"
                  "<td>40 %</td>"));
  EXPECT_TRUE(has(page, "width:25%\"></i></td><td>10.000 s</td><td>10 %</td>"));
  EXPECT_FALSE(has(page, "chord error between"));  // a hundred thousandth
  EXPECT_TRUE(
      has(page, "<tr id=\"lost1\" data-place=\"1\"><td><a class=\"rank\" href=\"#path\">1</a></td><td>11</td>"));
  EXPECT_TRUE(has(page, "G0 X99 (far)</td><td>rapid</td><td>300</td><td>9.000 s</td><td>11.000 s</td>"));
  EXPECT_TRUE(has(page, "<tr id=\"lost10\" data-place=\"10\">"));
  EXPECT_FALSE(has(page, "(cheap)"));
  std::size_t marks = 0;
  for (std::size_t at = 0; (at = page.find("<a class=\"place\"", at)) != std::string::npos; ++at) ++marks;
  EXPECT_EQ(marks, 40u);
}

std::size_t count_of(const std::string& page, std::string_view text) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = page.find(text, at)) != std::string::npos; ++at) ++count;
  return count;
}

/// In each of the four pictures all small marks, and large ones for the blocks of the table; in the heading the deepest.
TEST(Report, ShowsWhereTheToolGouges) {
  Recorded run(random_train(500, 2));
  EXPECT_FALSE(has(run.page(), "Where the tool gouges"));
  Gouging& found = run.report.gouging.emplace();
  found.tolerance_mm = 0.01;
  EXPECT_TRUE(has(run.page(), "Nowhere: no tool is more than 10 µm inside"));
  EXPECT_FALSE(has(run.page(), "as it was allowed to"));
  found.is_known = false;
  EXPECT_TRUE(has(run.page(), "Not looked at"));
  found.is_known = true;
  found.blocks = {{base::Line{12}, 2.66381, 0, "cutter", "pass <17>", 14, 3, 0.155153, 0.25, {1, 2, 3}},
                  {base::Line{12}, 0.5, 0, "holder", "the link behind pass 16", 1, 3, 0.5, 0.75, {2, 2, 3}},
                  {base::Line{14}, std::nullopt, 0.0111, {}, "pass 1", 0, 1, 0.5, 0, {3, 2, 3}}};
  found.places = {{1, 2, 3}, {2, 2, 3}, {1, 2.5, 3}, {1, 2.75, 3}};
  run.report.source = {{base::Line{12}, "G6.5 D3 <H0.1>"}};
  const std::string page = run.page();
  EXPECT_EQ(wrong_markup(page), "");
  EXPECT_TRUE(has(page, "as it was allowed to</strong>2.664 mm deep in surface 3 on pass &lt;17&gt; of line 12. "));
  EXPECT_TRUE(
      has(page, "<tr id=\"gouge1\" data-place=\"gouge1\"><td><a class=\"rank\" href=\"#path\">1</a></td><td>12</td>"));
  EXPECT_TRUE(
      has(page,
          "G6.5 D3 &lt;H0.1&gt;</td><td class=\"over-limit\">2.6638</td><td class=\"text\">pass "
          "&lt;17&gt;</td><td>3</td><td>0.155153</td><td>0.25</td><td class=\"text\">cutter, the deepest of 14"));
  EXPECT_TRUE(has(page, "0.5</td><td class=\"text\">the link behind pass 16</td><td>3</td><td>0.5</td><td>0.75</td>"));
  EXPECT_TRUE(has(page, "beside contact</td><td class=\"text\">pass 1</td><td>1</td><td>0.5</td><td>0</td>"));
  EXPECT_TRUE(has(page, "the surface bends by 0.0111 / mm more"));
  EXPECT_TRUE(has(page, "Diamonds: where <a href=\"#gouging\">the tool gouges</a>"));
  EXPECT_EQ(count_of(page, "<a class=\"place gouge\""), 4 * found.blocks.size());
  EXPECT_EQ(count_of(page, "<path d=\"M"), 4 * (found.places.size() + found.blocks.size()));
  found.blocks.resize(most_gouges + 3, found.blocks.front());
  EXPECT_TRUE(has(run.page(), "<p class=\"note\">And 3 more.</p>"));
  EXPECT_EQ(count_of(run.page(), "<a class=\"place gouge\""), 4 * most_gouges);
}

/// As far beyond the path as they may be, marks are inside the pictures.
TEST(Report, FramesWhereTheToolGouges) {
  Recorded run(random_train(500, 2));
  Gouging& found = run.report.gouging.emplace();
  found.places = {{5000, 0, 0}, {0, -4000, 0}, {0, 0, 3000}, {-100, 100, -2000}};
  const std::string page = run.page();
  std::size_t seen = 0;
  for (std::size_t at = page.find("<g class=\"gouges\">"); at != std::string::npos;
       at = page.find("<g class=\"gouges\">", at + 1)) {
    const std::size_t end = page.find("</g>", at);
    for (std::size_t mark = page.find("<path d=\"M", at); mark < end; mark = page.find("<path d=\"M", mark + 1)) {
      double x = 0, y = 0;
      ASSERT_EQ(std::sscanf(page.c_str() + mark, "<path d=\"M%lf %lf", &x, &y), 2);
      EXPECT_TRUE(10 < x && x < 590 && 3 < y && y < 410) << x << " " << y;
      ++seen;
    }
  }
  EXPECT_EQ(seen, 16u);
}

TEST(Report, ListsWhatTheRefereeObjectsTo) {
  Recorded run(random_train(500, 2));
  run.report.violation_count = 300;
  run.report.violations = {{base::Line{7}, "X jerk", 280, 0.25, 0.75, 31000, 20000}};
  run.report.source = {{base::Line{7}, "G1 X7"}};
  const std::string page = run.page();
  EXPECT_EQ(wrong_markup(page), "");
  EXPECT_FALSE(has(page, "Keeps every limit"));
  EXPECT_TRUE(has(page, "The referee objects in 300 words"));
  EXPECT_TRUE(has(page,
                  "X jerk</td><td class=\"over-limit\">31\u202f000</td><td>20\u202f000</td><td>280</td>"
                  "<td>0.250 s</td><td>0.750 s</td>"));
  EXPECT_TRUE(has(page, "And in 20 words more."));
}

TEST(Report, PassesOnWhatTheSinkSays) {
  const Recorded run(random_train(500, 2));
  for (const std::size_t room : {0, 1000}) {
    EXPECT_FALSE(write_report(run.report, run.recording, run.machine, millisecond, failing_after(room)));
    EXPECT_FALSE(write_path_svg("x", run.recording, failing_after(room)));
  }
}

TEST(PathPicture, FlatPathsAreSeenFromAbove) {
  std::vector<base::Word> words;
  for (int i = 0; i <= 100; ++i) {
    base::Word word;
    word.tick = base::Tick{i};
    word.position = {i * 1.0, 0, 0};
    word.feed = 10;
    words.push_back(word);
  }
  EXPECT_TRUE(has(Recorded(words).picture(), "l7520 0"));  // the whole width, level
  words.back().position[2] = 50;
  EXPECT_FALSE(has(Recorded(words).picture(), "l7520 0"));
}

}  // namespace test_report
}  // namespace leadscrew::report
