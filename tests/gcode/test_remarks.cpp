#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_remarks {

using Kind = Remark::Kind;

struct Told {
  std::vector<Remark> remarks;
  Reading reading;

  std::vector<std::string> texts() const {
    std::vector<std::string> result;
    for (const Remark& remark : remarks) result.push_back(remark.text);
    return result;
  }
};

Told tell(std::string_view text, Dialect dialect = Dialect::leadscrew) {
  Told told;
  Conditions conditions;
  conditions.options.file = "a.ngc";
  conditions.options.dialect = dialect;
  conditions.options.remarks = [&](const Remark& remark) { told.remarks.push_back(remark); };
  told.reading = read(text, conditions);
  return told;
}

using Texts = std::vector<std::string>;

TEST(Remarks, SayTheirText) {
  const Told told = tell("(MSG,hello #1 %d)\nG0 X1 ( debug,there)\n(Print, you)\nM2\n");
  EXPECT_EQ(told.texts(), (Texts{"hello #1 %d", "there", " you"}));
  EXPECT_EQ(told.remarks[0].kind, Kind::message);
  EXPECT_EQ(told.remarks[1].kind, Kind::message);
  EXPECT_EQ(told.remarks[2].kind, Kind::print);
  EXPECT_EQ(told.remarks[1].place.file, "a.ngc");
  EXPECT_EQ(told.remarks[1].place.line, 2);
  EXPECT_EQ(told.remarks[1].place.column, 9);
  EXPECT_EQ(told.reading.problems(), "");
}

TEST(Remarks, WriteValuesOut) {
  const struct {
    const char* text;
    const char* shown;
  } rows[] = {
      {"#1", "2.567000"},
      {"#<a b>", "3.000000"},
      {"#<AB>", "3.000000"},
      {"%d#1", "3"},
      {"%f#1", "2.5670"},
      {"%.3f #1", " 2.567"},
      {"%.0f#1", "3"},
      {"%d#1 #1 %.1f#1", "3 3 2.6"},
      {"%.f#1", "%.f2.567000"},
      {"%.12f#1", "%.12f2.567000"},
      {"%lf #1 %x %%", "%lf 2.567000 %x %%"},
      {"%%d #1", "% 3"},
      {"#7", "0.000000"},
      {"#<none>", "######"},
      {"#<_metric>", "1.000000"},
      {"#5420", "0.000000"},
      {"#31a", "7.000000a"},
      {"##31", "#7.000000"},
      {"#[1+1] # #x #-1", "#[1+1] # #x #-1"},
      {"#9999 #99999999999999999999", "###### ######"},
      {"#<none", "#<none"},
  };
  for (const auto& row : rows) {
    const Told told = tell("#1=2.567 #31=7 #<ab>=3\n(debug," + std::string(row.text) + ")\nM2\n");
    EXPECT_EQ(told.texts(), Texts{row.shown}) << row.text;
  }
}

TEST(Remarks, ComeBehindTheParametersAndBeforeTheMotionOfTheirBlock) {
  EXPECT_EQ(tell("G0 X3 #1=5 (debug,%d#1 #<_x>)\n(debug,%d#<_x>)\nM2\n").texts(), (Texts{"5 0", "3"}));
}

TEST(Remarks, AreReadFromTheLastOfALine) {
  EXPECT_EQ(tell("(debug,a)(debug,b)\n(debug,c)(d)\nG0 (e) X1 (debug,f)\nM2\n").texts(), (Texts{"b", "f"}));
  EXPECT_EQ(tell("(debug,a) ; b\nG0 X1 ;debug,c\r\n(debug,d) ;print,e\nM2\n").texts(), (Texts{"a", "c", "e"}));
}

TEST(Remarks, AreOrdinaryWithoutTheirComma) {
  EXPECT_EQ(tell("(abort)\n(message)\n(debug)\n(print this)\n(log x)\n(m s g, x)\n(MSGS, x)\nM2\n").texts(), Texts{});
}

TEST(Remarks, OfDebugCanBeSilenced) {
  EXPECT_EQ(tell("#5599=0\n(debug,a)\n(msg,b)\n#5599=1\n(debug,c)\nM2\n").texts(), (Texts{"b", "c"}));
}

TEST(Remarks, WriteLogs) {
  const Told told = tell("(LOGOPEN, a.txt )\n(LOG, %d#7)\n(LOGCLOSE)\n(LOGAPPEND,sub/b.txt)\n(LOG,y)\nM2\n");
  EXPECT_EQ(told.texts(), (Texts{"a.txt", " 0", "", "sub/b.txt", "y"}));
  std::vector<Kind> kinds;
  for (const Remark& remark : told.remarks) kinds.push_back(remark.kind);
  EXPECT_EQ(kinds, (std::vector{Kind::log_open, Kind::log, Kind::log_close, Kind::log_append, Kind::log}));
}

TEST(Remarks, WriteNoLogsOutsideOfTheFolder) {
  for (const char* const name : {"/etc/passwd", "../a.txt", "a/../../b.txt", "..", "a/.."}) {
    const Told told = tell("(LOGOPEN," + std::string(name) + ")\n(LOG,x)\nM2\n");
    EXPECT_EQ(told.texts(), Texts{}) << name;
    EXPECT_EQ(told.reading.problems(), "1:2 bad-log; 2:2 bad-log; ") << name;
    EXPECT_EQ(told.reading.errors, 0);
  }
  EXPECT_EQ(tell("(LOGOPEN,..a/b..c)\nM2\n").texts(), Texts{"..a/b..c"});
}

TEST(Remarks, TellWhatIsNotWritten) {
  EXPECT_EQ(tell("(LOG,x)\n(LOG,y)\nM2\n").reading.problems(), "1:2 bad-log; ");
  EXPECT_EQ(tell("(LOGOPEN, )\nM2\n").reading.problems(), "1:2 bad-log; ");
  EXPECT_EQ(tell("(py,x=1)\nM2\n").reading.problems(), "1:2 unsupported-remark; ");
}

TEST(Remarks, StopTheProgram) {
  const Told told = tell("#1=3\nG0 X1\nG0 X2 (ABORT, no tool %d#1)\nG0 X3 X4\nM2\n");
  EXPECT_EQ(told.reading.problems(), "3:8 program-abort; ");
  EXPECT_EQ(told.reading.diagnostics.back().message, "the program stops itself: no tool 3");
  EXPECT_EQ(told.reading.lines().size(), 1u);
  EXPECT_EQ(told.reading.of(Move::Kind::event).size(), 0u);
  EXPECT_EQ(tell(";abort,x\nM2\n").reading.problems(), "1:2 program-abort; ");
}

TEST(Remarks, MeanNothingInOtherDialects) {
  for (const Dialect dialect : {Dialect::fanuc, Dialect::haas, Dialect::grbl}) {
    const Told told = tell("(ABORT,x)\n(MSG,y)\nG0 X1\nM30\n", dialect);
    EXPECT_EQ(told.texts(), Texts{});
    EXPECT_EQ(told.reading.errors, 0);
  }
}

TEST(Remarks, AreNotReadBehindABadWord) {
  EXPECT_EQ(tell("G0 X$ (debug,a)\nM2\n").texts(), Texts{});
}

TEST(NestedComments, AreReadWhereTheyAreClosed) {
  const Told told = tell("G0 (a (b) c) X1\n(d(e(f)))\nM2\n");
  EXPECT_EQ(told.reading.problems(), "1:7 nested-comment; 2:3 nested-comment; ");
  EXPECT_EQ(told.reading.errors, 0);
  EXPECT_EQ(told.reading.lines().size(), 1u);
  EXPECT_EQ(tell("G0 (a (b c) X1\nM2\n").reading.errors, 1);
  EXPECT_EQ(tell("G0 (a (b) c) X1\nM2\n", Dialect::linuxcnc).reading.errors, 1);
}

}  // namespace test_remarks
}  // namespace leadscrew::gcode
