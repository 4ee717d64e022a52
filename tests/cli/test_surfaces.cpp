// leadscrew surfaces: the faces that a reading program beside the command tells of, as a table, JSON and blocks. tests/exchange has
// the real one.

#include <gtest/gtest.h>

#include <filesystem>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_surfaces {

constexpr std::string_view faces =
    R"({"format":"STEP","unit":"inch"}
{"face":{"number":1,"type":"plane","reversed":false,"deviation":null,"area":12.0,"low":[0,0,0],"high":[4,3,0],)"
    R"("degree":[1,1],"points":[2,2],"knots":[[0,0,1,1],[0,0,1,1]],"net":[0,0,0,1,4,0,0,1,0,3,0,1,4,3,0.1,1]}}
{"face":{"number":2,"type":"cylinder","reversed":true,"deviation":null,"area":50,"low":[0,0,0],"high":[4,3,1],)"
    R"("degree":[1,2],"points":[2,3],"knots":[[0,0,0.1,0.1],[0,0,0,1,1,1]],)"
    R"("net":[0,1,0,1,4,1,0,1,0,1,1e-7,0.5,4,1,1,0.5,0,0,1,1,4,0,1,1]}}
{"face":{"number":3,"type":"plane","reversed":false,"deviation":null,"area":null,"low":[0,0,0],"high":[0,0,0],)"
    R"("refusal":{"code":"face-trimmed","why":"is trimmed: it has 2 outlines","hint":"export its surface untrimmed"}}}
{"end":true}
)";

/// The command with a reading program beside it.
class Installed {
 public:
  explicit Installed(std::string_view lines) {
    std::filesystem::create_directory(folder.path() / "bin");
    std::filesystem::copy_file(LEADSCREW_COMMAND, folder.path() / "bin/leadscrew");
    folder.write("bin/leadscrew-exchange", "#!/bin/sh\ncat <<'E'\n" + std::string(lines) + "E\n");
    std::filesystem::permissions(folder.path() / "bin/leadscrew-exchange", std::filesystem::perms::owner_all);
    folder.write("part.step", "ISO-10303-21;\n");
  }

  Outcome surfaces(const std::string& words) const {
    const std::string line = "cd '" + folder.path().string() + "' && bin/leadscrew surfaces " + words + " >out 2>err";
    const int status = std::system(line.c_str());
    return {WEXITSTATUS(status), 0, folder.read("out"), folder.read("err")};
  }

  Folder folder;
};

TEST(Surfaces, AreListedWithWhatKeepsThemFromBeingMachined) {
  const Installed installed(faces);
  const Outcome outcome = installed.surfaces("part.step");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("part.step: STEP in inch, 3 faces, 2 of which can be machined\n"), std::string::npos);
  EXPECT_NE(outcome.output.find("\n      2  cylinder    1 x 2   2 x 3                50  4 x 3 x 1"), std::string::npos)
      << outcome.output;
  EXPECT_NE(outcome.output.find("u and v exchanged\n"), std::string::npos);
  EXPECT_NE(outcome.output.find("is trimmed: it has 2 outlines\n"), std::string::npos);
}

TEST(Surfaces, AreWrittenAsBlocks) {
  const Installed installed(faces);
  const Outcome outcome = installed.surfaces("part.step --face 2,1");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(outcome.output,
            "(part.step)\nG21\n"
            "(face 1, plane)\nG6.4 D1 P2 Q2 I2 J2\nX0 Y0 Z0\nX4 Y0 Z0\nX0 Y3 Z0\nX4 Y3 Z0.1\n"
            "(face 2, cylinder, u and v exchanged)\nG6.4 D2 P2 Q3 I2 J3\n"
            "X0 Y1 Z0 K0\nX4 Y1 Z0 K0\nX0 Y1 Z0.0000001 R0.5 K0.1\nX4 Y1 Z1 R0.5 K0.1\nX0 Y0 Z1\nX4 Y0 Z1\n");
  const Outcome all = installed.surfaces("part.step --all --output all.ngc");
  EXPECT_EQ(all.status, 0) << all.errors;
  EXPECT_EQ(all.output, "");
  EXPECT_NE(all.errors.find("warning: face 3 is trimmed: it has 2 outlines [face-trimmed]"), std::string::npos);
  EXPECT_EQ(installed.folder.read("all.ngc"), outcome.output);
}

TEST(Surfaces, ThatCannotBeMachinedAreNotWritten) {
  const Installed installed(faces);
  const Outcome outcome = installed.surfaces("part.step --face 1,3,4 --output face.ngc --json");
  EXPECT_EQ(outcome.status, 3);
  const Json json = outcome.json();
  ASSERT_EQ(json["diagnostics"].size(), 2u);
  EXPECT_EQ(json["diagnostics"][0]["code"], "face-trimmed");
  EXPECT_EQ(json["diagnostics"][1]["code"], "face-number");
  EXPECT_EQ(json["written"].size(), 0u);
  EXPECT_EQ(json["faces"].size(), 3u);
  EXPECT_FALSE(std::filesystem::exists(installed.folder.path() / "face.ngc"));
}

TEST(Surfaces, OfWhichNoneCanBeMachinedAreAnErrorTogether) {
  std::string lines(faces);
  lines.erase(lines.find("{\"face\":{\"number\":1"),
              lines.find("{\"face\":{\"number\":3") - lines.find("{\"face\":{\"number\":1"));
  const Outcome outcome = Installed(lines).surfaces("part.step --all");
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.errors.find("[exchange-faces]"), std::string::npos);
  EXPECT_EQ(outcome.output, "");
}

TEST(Surfaces, OfFilesThatAreNoneAreRefused) {
  const Installed installed(faces);
  installed.folder.write("empty.step", "");
  for (const auto& [file, status, code] : {std::tuple("empty.step", 3, "[exchange-format]"),
                                           {"bin/leadscrew", 3, "[exchange-format]"},
                                           {"bin", 4, "[io-read]"},
                                           {"none.step", 4, "[io-open]"}}) {
    const Outcome outcome = installed.surfaces(file);
    EXPECT_EQ(outcome.status, status) << file;
    EXPECT_NE(outcome.errors.find(code), std::string::npos) << outcome.errors;
    EXPECT_EQ(outcome.output, "");
  }
}

TEST(Surfaces, NeedABuildThatReadsThem) {
  const Installed installed(faces);
  std::filesystem::remove(installed.folder.path() / "bin/leadscrew-exchange");
  const Outcome outcome = installed.surfaces("part.step --json");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.output, "");
  EXPECT_NE(outcome.errors.find("[exchange-not-built]"), std::string::npos);
  EXPECT_NE(outcome.errors.find("LEADSCREW_EXCHANGE"), std::string::npos);
}

TEST(Surfaces, AreAskedForInWordsThatMakeSense) {
  const Installed installed(faces);
  for (const char* words : {"", "part.step --face 0", "part.step --face 1.5", "part.step --all --face 1",
                            "part.step --output x.ngc", "part.step --all --json", "part.step --approximate 0"}) {
    EXPECT_EQ(installed.surfaces(words).status, 2) << words;
  }
}

}  // namespace test_surfaces
}  // namespace leadscrew::cli::testing
