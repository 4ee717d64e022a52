// What the reading program says, and what becomes of files and programs that are not as they should be.

#include <gtest/gtest.h>

#include <filesystem>
#include <leadscrew/exchange/face_lines.hpp>
#include <leadscrew/exchange/faces.hpp>

#include "command.hpp"

namespace leadscrew::exchange {
namespace test_faces {

using cli::testing::Folder;
using surfaces::SurfaceForm;
using surfaces::uniform_knots;

SurfaceForm a_form() {
  SurfaceForm form{{1, 2}, {uniform_knots(2, 1), {0, 0, 0, 0.1, 1.0 / 3, 1.0 / 3, 1.0 / 3}}, {2, 4}, {}};
  for (int i = 0; i < 8; ++i) form.net.push_back({{10.0 * (i % 2), 1e-7 / 3 + i / 2, -1.0 / 7}, 1 + i / 9.0});
  return form;
}

Face a_face() {
  return {7, "B-spline", true, 1e-4 / 3, 12.5, {-1, 0, 1.0 / 3}, {2, 3, 4}, a_form(), {}};
}

const std::string header = line_of_header("STEP", "mm");
const std::string step = "ISO-10303-21;\n";

FaceLines taken(std::initializer_list<std::string> lines) {
  FaceLines result;
  for (const std::string& line : lines) EXPECT_TRUE(result.take(line)) << line;
  return result;
}

TEST(FaceLines, GiveEveryFaceBackToTheLastBit) {
  Face refused = a_face();
  refused.number = 8;
  refused.form.reset();
  refused.refusal = Refusal{"face-trimmed", "is \"trimmed\"", "hint"};
  refused.area.reset();
  const FaceLines lines = taken({header, line_of(a_face()), line_of(refused), line_of_end()});
  EXPECT_TRUE(lines.ended());
  ASSERT_EQ(lines.faces.faces.size(), 2u);
  EXPECT_EQ(lines.faces.format, "STEP");
  EXPECT_EQ(lines.faces.length_unit, "mm");
  const Face& face = lines.faces.faces[0];
  EXPECT_EQ(face.number, 7u);
  EXPECT_EQ(face.type, "B-spline");
  EXPECT_TRUE(face.is_reversed);
  EXPECT_EQ(face.deviation, 1e-4 / 3);
  EXPECT_EQ(face.area, 12.5);
  EXPECT_EQ(face.low, (surfaces::Vector{-1, 0, 1.0 / 3}));
  EXPECT_EQ(face.form, a_form());
  EXPECT_FALSE(face.refusal);
  EXPECT_FALSE(lines.faces.faces[1].form);
  EXPECT_EQ(lines.faces.faces[1].refusal, refused.refusal);
}

TEST(FaceLines, RefuseWhatIsNotOfThem) {
  EXPECT_FALSE(FaceLines().take("no JSON"));
  EXPECT_FALSE(FaceLines().take("[1]"));
  EXPECT_FALSE(FaceLines().take(line_of(a_face())));  // before the header
  EXPECT_FALSE(taken({header, line_of_end()}).take(line_of_end()));
  EXPECT_FALSE(taken({header}).take("{\"other\": 1}"));
  EXPECT_FALSE(taken({header}).take("{\"face\": {\"number\": 1}}"));
  const std::string line = line_of(a_face());
  for (const std::string part :
       {"\"number\":7", "\"low\":[", "\"net\":[", "\"degree\":[", "\"knots\":[[", "\"points\":["}) {
    std::string broken = line;
    ASSERT_NE(broken.find(part), std::string::npos) << line;
    broken.replace(broken.find(part), part.size(),
                   part.substr(0, part.find(':')) + "x\":" + part.substr(part.find(':') + 1));
    EXPECT_FALSE(taken({header}).take(broken)) << broken;
  }
}

TEST(FaceLines, TellAProblem) {
  const FaceLines lines = taken({line_of_problem("exchange-faces", "has no face", "export solids")});
  ASSERT_TRUE(lines.problem());
  EXPECT_EQ(lines.problem()->code, "exchange-faces");
  EXPECT_EQ(lines.problem()->why, "has no face");
}

TEST(ExchangeFormat, IsKnownByHowAFileBegins) {
  EXPECT_EQ(format_of("ISO-10303-21;\nHEADER;"), "STEP");
  EXPECT_EQ(format_of("\r\n  ISO-10303-21;"), "STEP");
  EXPECT_EQ(format_of(std::string(72, ' ') + "S      1\n"), "IGES");
  EXPECT_EQ(format_of(std::string(72, ' ') + "S0000001\r\n"), "IGES");
  EXPECT_EQ(format_of(std::string(72, ' ') + "G0000001\n"), "");
  EXPECT_EQ(format_of(""), "");
  EXPECT_EQ(format_of(" \n"), "");
  EXPECT_EQ(format_of("G21 G1 X1\n"), "");
  EXPECT_EQ(format_of("solid part\n"), "");
}

/// The code with which a file is refused that a program of the shell reads.
std::string code_of(const Folder& folder, const std::string& file, const std::string& shell) {
  folder.write("reader", "#!/bin/sh\n" + shell + "\n");
  std::filesystem::permissions(folder.path() / "reader", std::filesystem::perms::owner_all);
  const auto faces = read_faces(folder.path() / "reader", folder.path() / file, {});
  return faces ? "" : std::string(faces.error().code);
}

TEST(ReadingFaces, RefusesFilesThatAreNone) {
  const Folder folder;
  folder.write("part.step", step);
  folder.write("empty.step", "");
  folder.write("part.ngc", "G21\nM2\n");
  folder.write("binary.step", std::string("\0\1\2\377ISO-10303-21;", 18));
  folder.write("huge.step", step);
  std::filesystem::resize_file(folder.path() / "huge.step", std::uintmax_t{300} << 20);
  std::filesystem::create_directory(folder.path() / "folder.step");
  EXPECT_EQ(code_of(folder, "empty.step", "exit 0"), "exchange-format");
  EXPECT_EQ(code_of(folder, "part.ngc", "exit 0"), "exchange-format");
  EXPECT_EQ(code_of(folder, "binary.step", "exit 0"), "exchange-format");
  EXPECT_EQ(code_of(folder, "huge.step", "exit 0"), "input-too-large");
  EXPECT_EQ(code_of(folder, "folder.step", "exit 0"), "io-read");
  EXPECT_EQ(code_of(folder, "missing.step", "exit 0"), "io-open");
  const auto faces = read_faces("", folder.path() / "part.step", {});
  ASSERT_FALSE(faces);
  EXPECT_EQ(faces.error().code, "exchange-not-built");
  EXPECT_NE(faces.error().hint.find("LEADSCREW_EXCHANGE"), std::string::npos);
}

TEST(ReadingFaces, IsNotDeceivedByAProgramThatFails) {
  const Folder folder;
  folder.write("part.step", step);
  const auto line = [](std::string text) {
    text.pop_back();
    return "echo '" + text + "'\n";
  };
  const std::string whole = line(header) + line(line_of(a_face())) + line(line_of_end());
  EXPECT_EQ(code_of(folder, "part.step", whole), "");
  EXPECT_EQ(code_of(folder, "part.step", whole + "exit 1"), "exchange-read");
  EXPECT_EQ(code_of(folder, "part.step", line(header) + "kill -SEGV $$"), "exchange-read");
  EXPECT_EQ(code_of(folder, "part.step", line(header) + line(line_of(a_face()))), "exchange-read");
  EXPECT_EQ(code_of(folder, "part.step", "echo what"), "exchange-read");
  EXPECT_EQ(code_of(folder, "part.step", line(header) + "printf half"), "exchange-read");
  EXPECT_EQ(code_of(folder, "part.step", "exit 0"), "exchange-read");
  EXPECT_EQ(code_of(folder, "part.step", line(line_of_problem("exchange-faces", "", ""))), "exchange-faces");
  EXPECT_EQ(code_of(folder, "part.step", line(line_of_problem("other", "", ""))), "exchange-read");
  EXPECT_EQ(code_of(folder, "part.step", "head -c 70000000 /dev/zero | tr '\\0' x"), "input-too-large");
}

TEST(ReadingFaces, GivesItsProgramFormatFileAndTolerance) {
  const Folder folder;
  folder.write("part.step", step);
  folder.write("reader", "#!/bin/sh\nprintf '%s\\n' \"$@\" > \"$2.told\"\n");
  std::filesystem::permissions(folder.path() / "reader", std::filesystem::perms::owner_all);
  const std::string part = folder.path() / "part.step";
  EXPECT_FALSE(read_faces(folder.path() / "reader", part, 0.25));
  EXPECT_EQ(folder.read("part.step.told"), "STEP\n" + part + "\n0.25\n");
}

TEST(ReadingFaces, SaysWhichSurfacesCannotBeMachined) {
  const Folder folder;
  folder.write("part.step", step);
  std::string shell = "cat <<'E'\n" + header;
  const auto add = [&](const auto& change) {
    Face face = a_face();
    change(*face.form);
    shell += line_of(face);
  };
  add([](SurfaceForm&) {});
  add([](SurfaceForm& form) { form.net.pop_back(); });
  add([](SurfaceForm& form) { form.net[2].weight = 0; });
  add([](SurfaceForm& form) { form.knots[1][3] = -1; });
  add([](SurfaceForm& form) {
    for (std::size_t i : {0, 1}) form.net[2 + i] = form.net[i];
  });
  add([](SurfaceForm& form) { form.net[0].position = form.net[1].position; });
  folder.write("reader", "#!/bin/sh\n" + shell + line_of_end() + "E\n");
  std::filesystem::permissions(folder.path() / "reader", std::filesystem::perms::owner_all);
  const auto faces = read_faces(folder.path() / "reader", folder.path() / "part.step", {});
  ASSERT_TRUE(faces) << faces.error().message;
  ASSERT_EQ(faces->faces.size(), 6u);
  EXPECT_FALSE(faces->faces[0].refusal);
  const auto refused = [&](std::size_t i) { return faces->faces[i].refusal ? faces->faces[i].refusal->code : ""; };
  for (const std::size_t i : {1, 2, 3, 4}) EXPECT_EQ(refused(i), "face-net") << i;
  EXPECT_EQ(refused(5), "face-normal");
}

}  // namespace test_faces
}  // namespace leadscrew::exchange
