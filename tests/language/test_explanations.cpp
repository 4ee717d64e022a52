// What `explain` says, the page of all codes, and that the examples on it are read.

#include <fstream>
#include <leadscrew/gcode/dialect_forms.hpp>
#include <leadscrew/language/code_page.hpp>
#include <leadscrew/language/code_words.hpp>
#include <leadscrew/language/diagnostic_meaning.hpp>
#include <leadscrew/language/explanation.hpp>
#include <sstream>

#include "reading.hpp"

namespace leadscrew::language {
namespace test_explanations {

using gcode::Code;
using gcode::CodeRow;
using gcode::Dialect;

Dialect first_dialect(gcode::Dialects dialects) {
  for (std::size_t i = 0; i < index(Dialect::count); ++i) {
    if (dialects.has(static_cast<Dialect>(i))) return static_cast<Dialect>(i);
  }
  return Dialect::count;
}

gcode::Conditions conditions_of(Dialect dialect) {
  gcode::Conditions conditions;
  machine::Tool tool;
  tool.number = 1;
  tool.diameter = 10;
  tool.corner_radius = 5;
  conditions.tools = machine::ToolTable({tool});
  conditions.machine.rotary_chain = machine::preset_chain("table-table-ac");
  conditions.options.dialect = dialect;
  return conditions;
}

TEST(Examples, AreReadWhereTheirCodeIs) {
  for (const CodeRow& row : gcode::code_rows()) {
    const gcode::Reading reading =
        gcode::read(std::string(example_of(row.code)) + "\nM2\n", conditions_of(first_dialect(row.dialects)));
    std::string errors;
    for (const base::Diagnostic& each : reading.diagnostics) {
      if (each.severity == base::Severity::error) errors += std::string(each.code) + ": " + each.message + "\n";
    }
    if (row.read) {
      EXPECT_EQ(errors, "") << example_of(row.code);
    } else {
      EXPECT_NE(errors, "") << example_of(row.code) << " is read: its row says otherwise";
    }
  }
}

TEST(Explanations, TellEveryDiagnostic) {
  const std::vector<std::string_view> codes = diagnostic_codes();
  EXPECT_GT(codes.size(), 200u);
  for (const std::string_view code : codes) {
    EXPECT_TRUE(looks_like_diagnostic(code) || code.find('-') == std::string_view::npos) << code;
    const auto text = explanation(code, Dialect::leadscrew);
    ASSERT_TRUE(text) << code;
    EXPECT_TRUE(text->starts_with(std::string(code) + "\n        ")) << *text;
    EXPECT_NE(text->find("        What to do: "), std::string::npos) << *text;
  }
}

TEST(Explanations, OfADiagnosticHaveItsExample) {
  EXPECT_EQ(
      *explanation("zero-radius", Dialect::leadscrew),
      "zero-radius\n        an arc of pulses starts at its centre, or a semi-axis of its ellipse is not more than 0\n"
      "        What to do: a centre away from the start; a semi-axis of 1 or more\n");
  const std::string text = *explanation("bad-checksum", Dialect::leadscrew);
  EXPECT_TRUE(text.ends_with("\nsuch as N1 G0 X1*7\n")) << text;
}

TEST(Explanations, OfNoDiagnosticSayWhichWasMeant) {
  const auto none = explanation("arc-radus", Dialect::leadscrew);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, "unknown-code");
  EXPECT_NE(none.error().message.find("did you mean arc-radius?"), std::string::npos);
  EXPECT_FALSE(looks_like_diagnostic("G1X-5"));
  EXPECT_FALSE(looks_like_diagnostic("x1-"));
}

TEST(Examples, HoldTheirCode) {
  for (const CodeRow& row : gcode::code_rows()) {
    const std::string code = name(row.code);
    EXPECT_NE(std::string(example_of(row.code)).find(code), std::string::npos) << code;
  }
}

TEST(Words, OfEveryCodeHaveAMeaning) {
  for (const CodeRow& row : gcode::code_rows()) {
    for (const char letter : gcode::word_marks) {
      if (!row.words.has(letter)) continue;
      EXPECT_NE(meaning_of(row.code, letter).meaning, "") << name(row.code) << " " << letter;
    }
  }
}

std::string explained(std::string_view block, Dialect dialect = Dialect::leadscrew) {
  const auto text = explanation(block, dialect);
  return text ? *text : std::string(text.error().code);
}

bool has(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

TEST(Explanations, NameCodesAndTheirWords) {
  const std::string text = explained("N10 g41.1 D3 L 2 (finish)");
  for (const std::string_view part : {"cutter compensation of a given diameter", "D3", "3 mm or inches", "orientation",
                                      "dialects: leadscrew, linuxcnc", "remark"}) {
    EXPECT_TRUE(has(text, part)) << part << "\n" << text;
  }
}

TEST(Explanations, OfACodeAloneTellItsWordsAndAnExample) {
  const std::string text = explained("G64");
  for (const std::string_view part : {"rounds corners", "P_", "Q_", "such as", "G64 P0.02"}) {
    EXPECT_TRUE(has(text, part)) << part << "\n" << text;
  }
}

TEST(Explanations, TellWhichSpindle) {
  EXPECT_TRUE(has(explained("M19 R90 $0"), "$0    which spindle"));
  EXPECT_TRUE(has(explained("G33"), "$_    which spindle"));
}

TEST(Explanations, GoByTheDialect) {
  EXPECT_TRUE(has(explained("G76"), "threading cycle\n"));
  EXPECT_TRUE(has(explained("G76"), "in fanuc, haas, mach3: fine boring cycle"));
  EXPECT_TRUE(has(explained("G76", Dialect::fanuc), "G76     fine boring cycle"));
  EXPECT_TRUE(has(explained("M97"), "not of leadscrew"));
  EXPECT_TRUE(has(explained("G70", Dialect::mach3), "inches"));
}

TEST(Explanations, SayWhatIsNotKnown) {
  EXPECT_EQ(explained("G123"), "unknown-code");
  EXPECT_EQ(explained(""), "unknown-code");
  EXPECT_EQ(explained("?"), "unknown-code");
  EXPECT_TRUE(has(explained("G0 X1 Q5"), "nothing in this block takes it"));
}

TEST(CodePage, IsTheOneInTheDocuments) {
  std::ostringstream page;
  page << std::ifstream(LEADSCREW_SOURCE_DIR "/docs/gcode.md").rdbuf();
  EXPECT_TRUE(page.str() == code_page()) << "script/gcode writes docs/gcode.md anew";
}

TEST(Explanations, GoOnBehindSettings) {
  const auto text = explanation("#1=[2+3]g1 X#1#2=1 MOD 2 + LN[5]", Dialect::fanuc);
  ASSERT_TRUE(text);
  EXPECT_EQ(text->find("#1=[2+3] "), 0u) << *text;
  EXPECT_NE(text->find("G1 "), std::string::npos) << *text;
  EXPECT_NE(text->find("X#1 "), std::string::npos) << *text;
  EXPECT_NE(text->find("#2=1 MOD 2 + LN[5] "), std::string::npos) << *text;
}

}  // namespace test_explanations
}  // namespace leadscrew::language
